#include "TwoHalves.h"

#include "vtkStrataMaterialInterfaces.h"

#include <gtest/gtest.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkInformation.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

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
