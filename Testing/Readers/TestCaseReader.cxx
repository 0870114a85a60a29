#include "CaseFolder.h"

#include "vtkStrataCaseReader.h"
#include "vtkStrataTetrahedra.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

using namespace strata::test;

namespace
{
struct CaseReader : testing::Test
{
  vtkPartitionedDataSetCollection* output() { return reader->GetOutput(); }
  std::string blockName(unsigned int block) { return output()->GetMetaData(block)->Get(vtkCompositeDataSet::NAME()); }

  CaseFolder folder;
  vtkNew<vtkStrataCaseReader> reader;
};

/// The square x = 1/2, its normal pointing to +x.
const char* const squareText = R"(solid square
facet normal 1 0 0
outer loop
vertex 0.5 0 0
vertex 0.5 1 0
vertex 0.5 1 1
endloop
endfacet
facet normal 1 0 0
outer loop
vertex 0.5 0 0
vertex 0.5 1 1
vertex 0.5 0 1
endloop
endfacet
endsolid square
)";
}

TEST_F(CaseReader, SurfacesAreFoundWhereTheFileNamesNone)
{
  reader->SetFileName(folder.write("a.strata", caseText()).c_str());
  ASSERT_EQ(update(reader).error, "");
  ASSERT_EQ(output()->GetNumberOfPartitionedDataSets(), 2u);
  EXPECT_EQ(blockName(0), "grid");
  EXPECT_EQ(blockName(1), "left|right");
  EXPECT_EQ(output()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 2.5);
  EXPECT_GE(output()->GetDataAssembly()->FindFirstNodeWithName("grid"), 0);
}

TEST_F(CaseReader, TheGridsFieldDataSayWhatTheFileSaid)
{
  reader->SetFileName(folder.write("a.strata", caseText()).c_str());
  ASSERT_EQ(update(reader).error, "");
  vtkFieldData* data = output()->GetPartition(0, 0)->GetFieldData();
  EXPECT_EQ(data->GetAbstractArray("material_names")->GetVariantValue(1).ToString(), "right");
  EXPECT_EQ(data->GetArray("material_has_fields")->GetTuple1(1), 0.0);
  EXPECT_EQ(data->GetAbstractArray("strata_fraction_arrays")->GetVariantValue(0).ToString(), "volume_fraction_left");
  EXPECT_EQ(data->GetAbstractArray("strata_field_arrays")->GetNumberOfValues(), 6);
}

TEST_F(CaseReader, FiltersNeedNoFurtherSettings)
{
  reader->SetFileName(folder.write("a.strata", caseText()).c_str());
  vtkNew<vtkStrataTetrahedra> tetrahedra;
  tetrahedra->SetInputConnection(reader->GetOutputPort());
  ASSERT_EQ(update(tetrahedra).error, "");
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(tetrahedra->GetOutputDataObject(0));
  EXPECT_TRUE(mesh->GetPointData()->HasArray("rho_left"));
  EXPECT_FALSE(mesh->GetPointData()->HasArray("rho_right")); // without fields
}

TEST_F(CaseReader, SurfacesAreReadFromFiles)
{
  folder.write("square.stl", squareText);
  const std::string steps = R"([{"time": 0, "grid": "halves.vti",
    "interfaces": [{"surface": "square.stl", "positive": "right", "negative": "left"}]}])";
  reader->SetFileName(folder.write("a.strata", caseText(steps)).c_str());
  ASSERT_EQ(update(reader).error, "");
  ASSERT_EQ(output()->GetNumberOfPartitionedDataSets(), 2u);
  EXPECT_EQ(blockName(1), "right|left");
  auto* surface = vtkPolyData::SafeDownCast(output()->GetPartition(1, 0));
  EXPECT_EQ(surface->GetCellData()->GetArray("positive_material")->GetTuple1(0), 1.0);
  vtkNew<vtkStrataTetrahedra> tetrahedra;
  tetrahedra->SetInputConnection(reader->GetOutputPort());
  EXPECT_EQ(update(tetrahedra).error, "");
}

TEST_F(CaseReader, TheLastStepNotAfterTheTimeIsTaken)
{
  const std::string steps = R"([{"time": 1, "grid": "halves.vti"}, {"time": 2, "grid": "halves.vti"}])";
  reader->SetFileName(folder.write("a.strata", caseText(steps)).c_str());
  reader->UpdateInformation();
  EXPECT_EQ(reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 2);
  for (const auto& [asked, got] :
    { std::pair(0.0, 1.0), std::pair(1.7, 1.0), std::pair(2.0, 2.0), std::pair(9.0, 2.0) })
  {
    reader->UpdateTimeStep(asked);
    EXPECT_EQ(output()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), got);
  }
}

TEST_F(CaseReader, OneMaterialMayBeTheRest)
{
  reader->SetFileName(
    folder.write("a.strata", caseText(R"([{"grid": "halves.vti"}])", R"({"left": "volume_fraction_left"})")).c_str());
  ASSERT_EQ(update(reader).error, "");
  EXPECT_EQ(blockName(1), "left|right");
}
