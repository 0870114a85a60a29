#include "TwoHalves.h"

#include "vtkStrataError.h"
#include "vtkStrataExtractMaterials.h"
#include "vtkStrataRepresentedInterfaces.h"
#include "vtkStrataSample.h"
#include "vtkStrataSlice.h"
#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkTable.h>
#include <vtkTetra.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <map>

using namespace strata::test;

namespace
{
struct RepresentationFilters : testing::Test
{
  RepresentationFilters()
  {
    tetrahedra->SetInputData(twoHalves(8));
    tetrahedra->SetInterfaceErrorBound(0.05);
  }

  vtkPolyData* cut(const double (&origin)[3], const double (&normal)[3])
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin[0], origin[1], origin[2]);
    plane->SetNormal(normal[0], normal[1], normal[2]);
    slice->SetSliceType(plane);
    slice->SetInputConnection(tetrahedra->GetOutputPort());
    EXPECT_EQ(update(slice).error, "");
    return vtkPolyData::SafeDownCast(slice->GetOutputDataObject(0));
  }

  vtkNew<vtkStrataTetrahedra> tetrahedra;
  vtkNew<vtkStrataSlice> slice;
};

std::map<int, double> areas(vtkPolyData* polygons)
{
  std::map<int, double> result;
  vtkDataArray* material = polygons->GetCellData()->GetArray("material");
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    double normal[3];
    vtkCell* polygon = polygons->GetCell(cell);
    const double area = vtkPolygon::ComputeArea(
      polygons->GetPoints(), polygon->GetNumberOfPoints(), polygon->GetPointIds()->GetPointer(0), normal);
    result[static_cast<int>(material->GetTuple1(cell))] += area;
  }
  return result;
}
}

TEST_F(RepresentationFilters, SlicesFillTheSectionMaterialByMaterial)
{
  const auto parts = areas(cut({ 0.5, 0.37, 0.5 }, { 0.0, 2.0, 0.0 }));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts.at(0), 0.5, 1e-5);
  EXPECT_NEAR(parts.at(0) + parts.at(1), 1.0, 1e-9);
}

TEST_F(RepresentationFilters, SlicesCarryTheFieldsOfTheirMaterial)
{
  vtkPolyData* polygons = cut({ 0.5, 0.37, 0.5 }, { 0.0, 1.0, 0.0 });
  vtkDataArray* density = polygons->GetPointData()->GetArray("density");
  ASSERT_TRUE(density);
  vtkDataArray* material = polygons->GetCellData()->GetArray("material");
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    vtkIdList* corners = polygons->GetCell(cell)->GetPointIds();
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      const vtkIdType i = corners->GetId(k);
      const double expected = material->GetTuple1(cell) == 0.0 ? 1.37 : 10.0 - polygons->GetPoint(i)[2];
      EXPECT_NEAR(density->GetTuple1(i), expected, 1e-4);
    }
  }
}

TEST_F(RepresentationFilters, EachOffsetAddsASlice)
{
  slice->SetNumberOfSliceOffsets(2);
  slice->SetSliceOffset(0, -0.2);
  slice->SetSliceOffset(1, 0.2);
  const auto parts = areas(cut({ 0.5, 0.5, 0.5 }, { 0.0, 3.0, 0.0 }));
  EXPECT_NEAR(parts.at(0) + parts.at(1), 2.0, 1e-9);
}

TEST_F(RepresentationFilters, MaterialsCanBeChosenByName)
{
  slice->AddMaterial("right");
  const auto parts = areas(cut({ 0.5, 0.5, 0.37 }, { 0.0, 0.0, 1.0 }));
  EXPECT_EQ(parts.count(0), 0u);
  EXPECT_NEAR(parts.at(1), 0.5, 1e-5);
  slice->AddMaterial("lead");
  EXPECT_REFUSED(slice, "lead", "'left', 'right'");
}

TEST_F(RepresentationFilters, AZeroNormalIsRefused)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, 0.0);
  slice->SetSliceType(plane);
  slice->SetInputConnection(tetrahedra->GetOutputPort());
  EXPECT_REFUSED(slice, "normal");
}

TEST_F(RepresentationFilters, OtherGridsAreRefused)
{
  vtkNew<vtkUnstructuredGrid> other;
  slice->SetInputData(other);
  EXPECT_REFUSED(slice, "no representation", "material_names");
}

TEST_F(RepresentationFilters, ASavedRepresentationSlicesTheSame)
{
  tetrahedra->Update();
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputConnection(tetrahedra->GetOutputPort());
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  vtkPolyData* before = cut({ 0.5, 0.37, 0.5 }, { 0.2, 1.0, 0.3 });
  vtkNew<vtkStrataSlice> again;
  again->SetSliceType(slice->GetSliceType());
  again->SetInputConnection(reader->GetOutputPort());
  ASSERT_EQ(update(again).error, "");
  auto* after = vtkPolyData::SafeDownCast(again->GetOutputDataObject(0));
  ASSERT_EQ(after->GetNumberOfPoints(), before->GetNumberOfPoints());
  ASSERT_EQ(after->GetNumberOfCells(), before->GetNumberOfCells());
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(after->GetPoint(i)[0], before->GetPoint(i)[0]);
    EXPECT_EQ(after->GetPointData()->GetArray("density")->GetTuple1(i),
      before->GetPointData()->GetArray("density")->GetTuple1(i));
  }
}

TEST_F(RepresentationFilters, PiecesHaveTheVolumeOfTheirMaterial)
{
  vtkNew<vtkStrataExtractMaterials> extract;
  extract->SetInputConnection(tetrahedra->GetOutputPort());
  extract->AddMaterial("left");
  ASSERT_EQ(update(extract).error, "");
  auto* pieces = vtkUnstructuredGrid::SafeDownCast(extract->GetOutputDataObject(0));
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < pieces->GetNumberOfCells(); ++cell)
  {
    double p[4][3];
    for (int i = 0; i < 4; ++i)
    {
      pieces->GetPoint(pieces->GetCell(cell)->GetPointId(i), p[i]);
    }
    volume += vtkTetra::ComputeVolume(p[0], p[1], p[2], p[3]);
  }
  EXPECT_NEAR(volume, 0.5, 1e-5);
}

TEST_F(RepresentationFilters, InterfacesKnowTheJumpOfTheField)
{
  vtkNew<vtkStrataRepresentedInterfaces> interfaces;
  interfaces->SetInputConnection(tetrahedra->GetOutputPort());
  ASSERT_EQ(update(interfaces).error, "");
  vtkPolyData* surface = interfaces->GetOutput();
  ASSERT_GT(surface->GetNumberOfCells(), 0);
  vtkDataArray* jump = surface->GetPointData()->GetArray("density_jump");
  ASSERT_TRUE(jump);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    EXPECT_NEAR(p[0], 0.5, 1e-5);
    EXPECT_NEAR(jump->GetTuple1(i), (1.0 + p[1]) - (10.0 - p[2]), 1e-4);
  }
}

TEST_F(RepresentationFilters, SamplesAnswerAtAnyPoints)
{
  vtkNew<vtkImageData> points;
  points->SetDimensions(4, 3, 3);
  points->SetOrigin(0.1, 0.1, 0.1);
  points->SetSpacing(0.35, 0.3, 0.3); // x: 0.1, 0.45, 0.8, 1.15
  vtkNew<vtkStrataSample> sample;
  sample->SetInputConnection(0, tetrahedra->GetOutputPort());
  sample->SetInputDataObject(1, points);
  ASSERT_EQ(update(sample).error, "");
  vtkDataSet* output = vtkDataSet::SafeDownCast(sample->GetOutputDataObject(0));
  ASSERT_EQ(output->GetNumberOfPoints(), 36);
  for (vtkIdType i = 0; i < 36; ++i)
  {
    const double* p = output->GetPoint(i);
    const bool outside = p[0] > 1.0;
    EXPECT_EQ(output->GetPointData()->GetArray("outside")->GetTuple1(i), outside ? 1.0 : 0.0);
    EXPECT_EQ(output->GetPointData()->GetArray("material")->GetTuple1(i), outside ? -1.0 : p[0] > 0.5 ? 1.0 : 0.0);
    if (!outside)
    {
      EXPECT_NEAR(
        output->GetPointData()->GetArray("density")->GetTuple1(i), p[0] > 0.5 ? 10.0 - p[2] : 1.0 + p[1], 1e-4);
    }
  }
}

TEST_F(RepresentationFilters, ErrorsAreMeasuredAgainstTheOriginal)
{
  vtkNew<vtkStrataError> error;
  error->SetInputConnection(0, tetrahedra->GetOutputPort());
  error->SetInputDataObject(1, twoHalves(8));
  ASSERT_EQ(update(error).error, "");
  auto* table = vtkTable::SafeDownCast(error->GetOutputDataObject(0));
  ASSERT_EQ(
    table->GetNumberOfRows(), 8); // two fields, one interface, two regions and volumes, the misclassified volume
  EXPECT_LE(table->GetValueByName(0, "largest").ToDouble(), 1e-4);
  EXPECT_EQ(table->GetValueByName(3, "kind").ToString(), "region");
  EXPECT_LE(table->GetValueByName(3, "original_to_represented_lower").ToDouble(), 1e-4);
  EXPECT_NEAR(table->GetValueByName(5, "represented_volume").ToDouble(), 0.5, 1e-5);
  EXPECT_NEAR(table->GetValueByName(5, "original_volume").ToDouble(), 0.5, 1e-9);
  EXPECT_NEAR(table->GetValueByName(5, "original_mass").ToDouble(), 0.75, 1e-5); // mean of 1 + y over half the cube
}
