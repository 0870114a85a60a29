#include "TwoHalves.h"

#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <chrono>
#include <cstring>
#include <set>
#include <string>

using namespace strata::test;

namespace
{
using Clock = std::chrono::steady_clock;

/// A run that is aborted some time after its first progress event, and what it told until then.
struct AbortedRun
{
  double abortAfter; ///< seconds
  Clock::time_point first;
  Clock::time_point asked;
  bool started = false;
  bool aborted = false;
  std::set<std::string> stages;

  static void onProgress(vtkObject* caller, unsigned long, void* data, void*)
  {
    auto* run = static_cast<AbortedRun*>(data);
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    const std::string stage = filter->GetProgressText() ? filter->GetProgressText() : "";
    if (stage.empty() && !run->started)
    {
      return; // VTK's own event before the filter is called
    }
    const Clock::time_point now = Clock::now();
    run->first = run->started ? run->first : now;
    run->started = true;
    run->stages.insert(stage);
    if (!run->aborted && std::chrono::duration<double>(now - run->first).count() >= run->abortAfter)
    {
      run->aborted = true;
      run->asked = now;
      filter->SetAbortExecute(1);
    }
  }
};

void expectSameArrays(vtkFieldData* a, vtkFieldData* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* left = a->GetArray(i);
    vtkDataArray* right = b->GetArray(i);
    if (!left || !right)
    {
      continue; // texts
    }
    ASSERT_EQ(left->GetDataSize(), right->GetDataSize()) << left->GetName();
    const auto bytes = static_cast<std::size_t>(left->GetDataSize() * left->GetDataTypeSize());
    EXPECT_EQ(std::memcmp(left->GetVoidPointer(0), right->GetVoidPointer(0), bytes), 0) << left->GetName();
  }
}

void expectSameBytes(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    a->GetPoint(i, p);
    const double* q = b->GetPoint(i);
    ASSERT_TRUE(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) << "point " << i;
  }
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      ASSERT_EQ(a->GetCell(cell)->GetPointId(corner), b->GetCell(cell)->GetPointId(corner)) << "cell " << cell;
    }
  }
  expectSameArrays(a->GetPointData(), b->GetPointData());
  expectSameArrays(a->GetCellData(), b->GetCellData());
  expectSameArrays(a->GetFieldData(), b->GetFieldData());
}

/// Where the sliders are.
struct Setting
{
  double interfaceBound;
  double fieldBound;
  vtkIdType limit; ///< 0: none
};

void move(vtkStrataTetrahedra* filter, const Setting& setting)
{
  filter->SetInterfaceErrorBound(setting.interfaceBound);
  filter->SetFieldErrorBound(setting.fieldBound);
  filter->SetLimitCells(setting.limit > 0);
  filter->SetMaximumNumberOfCells(setting.limit > 0 ? setting.limit : 1);
}

class Slider : public testing::TestWithParam<int>
{
};

class AbortedAfter : public testing::TestWithParam<double>
{
};

vtkUnstructuredGrid* meshOf(vtkStrataTetrahedra* filter)
{
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}
}

TEST_P(Slider, SlidingGivesTheBytesOfStartingThereAndReadsNothingAgain)
{
  const vtkSmartPointer<vtkImageData> input = twoWaves(8);
  vtkNew<vtkStrataTetrahedra> slid;
  slid->SetInputData(input);
  slid->SetErrorMethod(GetParam());
  for (const Setting& setting : { Setting{ 0.1, 0.1, 0 }, { 0.01, 0.01, 0 }, { 0.3, 0.2, 0 }, { 0.01, 0.002, 300 },
         { 0.05, 0.02, 0 }, { 0.01, 0.002, 2000 } })
  {
    move(slid, setting);
    ASSERT_EQ(update(slid).error, "");
    vtkNew<vtkStrataTetrahedra> fresh;
    fresh->SetInputData(input);
    fresh->SetErrorMethod(GetParam());
    move(fresh, setting);
    ASSERT_EQ(update(fresh).error, "");
    expectSameBytes(meshOf(slid), meshOf(fresh));
  }
  EXPECT_EQ(slid->GetNumberOfBuilds(), 1);
}

TEST(KeptInterfaces, AreExtractedAnewOnlyWhereTheGridOrTheFractionsChange)
{
  const vtkSmartPointer<vtkImageData> input = twoWaves(8);
  vtkNew<vtkStrataTetrahedra> kept;
  kept->SetInputData(input);
  const auto extractionsAfter = [&](int nativeElements) {
    // Whatever was kept, the bytes are those of a filter that has seen nothing else.
    vtkNew<vtkStrataTetrahedra> fresh;
    fresh->SetInputData(input);
    input->Modified();
    for (vtkStrataTetrahedra* filter : { kept.Get(), fresh.Get() })
    {
      filter->SetNativeElements(nativeElements);
      move(filter, { 0.05, 0.05, 0 });
      EXPECT_EQ(update(filter).error, "");
    }
    expectSameBytes(meshOf(kept), meshOf(fresh));
    return kept->GetNumberOfExtractions();
  };
  const int points = vtkStrataTetrahedra::POINTS;
  const int cells = vtkStrataTetrahedra::CELLS;
  EXPECT_EQ(extractionsAfter(points), 1);
  cellArray(input, "density_left")->SetValue(0, 9.0f);
  EXPECT_EQ(extractionsAfter(points), 1);
  EXPECT_EQ(extractionsAfter(cells), 1);
  cellArray(input, "density_right")->SetValue(7, 30.0f);
  EXPECT_EQ(extractionsAfter(cells), 1);
  kept->SetDistanceMethod(vtkStrataTetrahedra::CLOSEST_VERTEX);
  kept->Update();
  kept->SetDistanceMethod(vtkStrataTetrahedra::CLOSEST_POINT);
  EXPECT_EQ(extractionsAfter(points), 1);
  // One cell's material changes sides: the interface does not stay.
  cellArray(input, "volume_fraction_left")->SetValue(0, 0.0f);
  cellArray(input, "volume_fraction_right")->SetValue(0, 1.0f);
  EXPECT_EQ(extractionsAfter(points), 2);
  input->SetOrigin(3.0, 0.0, 0.0);
  EXPECT_EQ(extractionsAfter(points), 3);
}

TEST(KeptLevels, NothingIsLeftOfFittedLevelsOnceTheInputTheFieldsOrBuildOptionsChange)
{
  const vtkSmartPointer<vtkImageData> input = twoWaves(8);
  for (const std::string side : { "left", "right" })
  {
    vtkNew<vtkFloatArray> warmth;
    warmth->DeepCopy(cellArray(input, ("density_" + side).c_str()));
    warmth->SetValue(5, 7.0f);
    warmth->SetName(("warmth_" + side).c_str());
    input->GetCellData()->AddArray(warmth);
  }
  vtkNew<vtkStrataTetrahedra> kept;
  const auto expectFresh = [&](const char* field, int cubes, int arrays) {
    vtkNew<vtkStrataTetrahedra> fresh;
    for (vtkStrataTetrahedra* filter : { kept.Get(), fresh.Get() })
    {
      filter->SetInputData(input);
      filter->SetErrorMethod(vtkStrataTetrahedra::FITTED);
      filter->ClearFieldArrays();
      filter->AddFieldArray(field);
      filter->SetBaseCubes(cubes, 1, 1);
      filter->SetPassArrays(arrays);
      move(filter, { 0.05, 0.02, 0 });
      ASSERT_EQ(update(filter).error, "");
    }
    expectSameBytes(meshOf(kept), meshOf(fresh));
  };
  expectFresh("density", 1, vtkStrataTetrahedra::ALL);
  cellArray(input, "density_left")->SetValue(0, 9.0f);
  input->Modified();
  expectFresh("density", 1, vtkStrataTetrahedra::ALL);
  expectFresh("warmth", 1, vtkStrataTetrahedra::ALL);
  expectFresh("warmth", 2, vtkStrataTetrahedra::ALL);
  expectFresh("warmth", 2, vtkStrataTetrahedra::COMPOSITE_ONLY);
  EXPECT_EQ(kept->GetNumberOfBuilds(), 4);
}

INSTANTIATE_TEST_SUITE_P(OfEveryErrorMethod, Slider,
  testing::Values(vtkStrataTetrahedra::DIRECT, vtkStrataTetrahedra::SATURATED, vtkStrataTetrahedra::FITTED,
    vtkStrataTetrahedra::ACCUMULATED));

TEST_P(AbortedAfter, ALongRunStopsWhenAsked)
{
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetInputData(twoWaves(64));
  filter->SetInterfaceErrorBound(1e-5);
  filter->SetFieldErrorBound(1e-6);
  AbortedRun run{ GetParam(), {}, {}, false, false, {} };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(AbortedRun::onProgress);
  observer->SetClientData(&run);
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  EXPECT_EQ(update(filter).error, "");
  const double took = std::chrono::duration<double>(Clock::now() - run.asked).count();
  ASSERT_TRUE(run.aborted) << "the run is too short for the test";
  EXPECT_EQ(cellsOf(filter), 0);
  // A busy machine decides the time, so it is told, not tested.
  RecordProperty("milliseconds", static_cast<int>(1000.0 * took));
  EXPECT_EQ(run.stages.count(""), 0u) << "each stage has a name";
  EXPECT_FALSE(run.stages.empty());
}

INSTANTIATE_TEST_SUITE_P(SomeSeconds, AbortedAfter, testing::Values(0.0, 0.05, 0.3, 1.0));
