#include "TwoHalves.h"

#include "vtkStrataMaterialInterfaces.h"

#include <gtest/gtest.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkInformation.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkVector.h>

using namespace strata::test;

namespace
{
struct MaterialInterfaces : testing::Test
{
  MaterialInterfaces() { filter->SetInputData(twoHalves(4)); }
  vtkPartitionedDataSetCollection* output()
  {
    return vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  }
  vtkNew<vtkStrataMaterialInterfaces> filter;
};
}

TEST_F(MaterialInterfaces, ThereIsOneNamedSurfacePerPair)
{
  ASSERT_EQ(update(filter).error, "");
  ASSERT_EQ(output()->GetNumberOfPartitionedDataSets(), 1u);
  EXPECT_STREQ(output()->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()), "left|right");
  vtkDataAssembly* assembly = output()->GetDataAssembly();
  EXPECT_GE(assembly->FindFirstNodeWithName("pairs"), 0);
  EXPECT_GE(assembly->FindFirstNodeWithName("materials"), 0);
  EXPECT_EQ(assembly->GetDataSetIndices(assembly->FindFirstNodeWithName("left")).size(), 1u);
}

TEST_F(MaterialInterfaces, ItLiesWhereTheMaterialsMeetAndPointsIntoThePositiveOne)
{
  ASSERT_EQ(update(filter).error, "");
  auto* surface = vtkPolyData::SafeDownCast(output()->GetPartition(0, 0));
  ASSERT_TRUE(surface);
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_TRUE(normals);
  EXPECT_EQ(surface->GetCellData()->GetArray("positive_material")->GetTuple1(0), 0.0);
  EXPECT_EQ(surface->GetCellData()->GetArray("negative_material")->GetTuple1(0), 1.0);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(surface->GetPoint(i)[0], 0.5, 1e-9);
    EXPECT_NEAR(normals->GetTuple3(i)[0], -1.0, 1e-6); // left lies at smaller x
  }
}

TEST_F(MaterialInterfaces, VolumesAreReported)
{
  filter->VolumeErrorsOn();
  ASSERT_EQ(update(filter).error, "");
  vtkDataArray* volumes = output()->GetFieldData()->GetArray("volume_reconstructed");
  ASSERT_TRUE(volumes);
  EXPECT_NEAR(volumes->GetTuple1(0), 0.5, 1e-6);
  ASSERT_EQ(output()->GetNumberOfPartitionedDataSets(), 2u);
  vtkDataSet* grid = output()->GetPartition(1, 0);
  ASSERT_TRUE(grid && grid->GetCellData()->HasArray("volume_error_left"));
  EXPECT_EQ(grid->GetCellData()->GetArray("volume_error_left")->GetNumberOfTuples(), 64);
}

TEST_F(MaterialInterfaces, AreExtractedAnewOnlyWhereTheGridTheFractionsOrTheOptionsChange)
{
  const vtkSmartPointer<vtkImageData> input = twoHalves(4);
  filter->SetInputData(input);
  const auto expectFresh = [&](int extractions) {
    input->Modified();
    vtkNew<vtkStrataMaterialInterfaces> fresh;
    fresh->SetInputData(input);
    fresh->SetVolumeErrors(filter->GetVolumeErrors());
    fresh->SetVolumeCorrection(filter->GetVolumeCorrection());
    ASSERT_EQ(update(filter).error, "");
    ASSERT_EQ(update(fresh).error, "");
    EXPECT_EQ(filter->GetNumberOfExtractions(), extractions);
    auto* expected = vtkPartitionedDataSetCollection::SafeDownCast(fresh->GetOutputDataObject(0));
    ASSERT_EQ(output()->GetNumberOfPartitionedDataSets(), expected->GetNumberOfPartitionedDataSets());
    auto* surface = vtkPolyData::SafeDownCast(output()->GetPartition(0, 0));
    auto* other = vtkPolyData::SafeDownCast(expected->GetPartition(0, 0));
    ASSERT_EQ(surface->GetNumberOfPoints(), other->GetNumberOfPoints());
    ASSERT_EQ(surface->GetNumberOfCells(), other->GetNumberOfCells());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(vtkVector3d(surface->GetPoint(i)), vtkVector3d(other->GetPoint(i)));
    }
    EXPECT_EQ(output()->GetFieldData()->GetArray("volume_reconstructed")->GetTuple1(0),
      expected->GetFieldData()->GetArray("volume_reconstructed")->GetTuple1(0));
  };
  expectFresh(1);
  cellArray(input, "density_left")->SetValue(0, 9.0f);
  expectFresh(1);
  filter->VolumeErrorsOn();
  expectFresh(2);
  filter->VolumeErrorsOff();
  expectFresh(2);
  filter->VolumeCorrectionOff();
  expectFresh(3);
  cellArray(input, "volume_fraction_left")->SetValue(0, 0.0f);
  cellArray(input, "volume_fraction_right")->SetValue(0, 1.0f);
  expectFresh(4);
  input->SetSpacing(1.0, 1.0, 1.0);
  expectFresh(5);
}
