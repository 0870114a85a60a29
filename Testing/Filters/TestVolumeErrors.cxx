#include "TwoHalves.h"

#include "vtkStrataMaterialInterfaces.h"

#include <gtest/gtest.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

using namespace strata::test;

namespace
{
constexpr int cells = 4;
constexpr int layer = cells * cells;

/// Two materials whose border is rough: without a correction no cell of the border gets the volume of its fractions.
vtkSmartPointer<vtkImageData> roughHalves()
{
  auto image = twoHalves(cells);
  for (vtkIdType cell = 1; cell < image->GetNumberOfCells(); cell += cells)
  {
    const float left = 0.2f + 0.6f * static_cast<float>(cell * 7 % 31) / 31.0f;
    cellArray(image, "volume_fraction_left")->SetValue(cell, left);
    cellArray(image, "volume_fraction_right")->SetValue(cell, 1.0f - left);
    cellArray(image, "density_right")->SetValue(cell, 5.0f);
  }
  return image;
}

/// The cells from `begin` to `end` along z.
vtkSmartPointer<vtkImageData> slab(int begin, int end)
{
  vtkSmartPointer<vtkImageData> image = roughHalves();
  cropAlongZ(image, begin, end);
  return image;
}

struct VolumeErrors : testing::Test
{
  VolumeErrors()
  {
    filter->VolumeErrorsOn();
    filter->VolumeCorrectionOff();
  }

  /// The blocks of the grid with the errors, which is the last of the output.
  vtkPartitionedDataSet* run(vtkDataObject* input)
  {
    filter->SetInputDataObject(input);
    EXPECT_EQ(update(filter).error, "");
    auto* output = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
    return output->GetPartitionedDataSet(output->GetNumberOfPartitionedDataSets() - 1);
  }

  /// Reconstructed minus given volume of a material, in total.
  double totalError(int material)
  {
    vtkFieldData* totals = filter->GetOutputDataObject(0)->GetFieldData();
    return totals->GetArray("volume_reconstructed")->GetTuple1(material) -
           totals->GetArray("volume_given")->GetTuple1(material);
  }

  vtkNew<vtkStrataMaterialInterfaces> filter;
};

vtkDataArray* errorsOfLeft(vtkPartitionedDataSet* grid, unsigned int block)
{
  return grid->GetPartition(block)->GetCellData()->GetArray("volume_error_left");
}
}

TEST_F(VolumeErrors, EachBlockHasThoseOfItsOwnCells)
{
  vtkNew<vtkDoubleArray> whole;
  whole->DeepCopy(errorsOfLeft(run(roughHalves()), 0));
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, slab(0, 1));
  blocks->SetBlock(1, vtkNew<vtkUnstructuredGrid>());
  blocks->SetBlock(2, sphere->GetOutput());
  blocks->SetBlock(3, slab(1, cells));
  vtkPartitionedDataSet* grid = run(blocks);
  ASSERT_EQ(grid->GetNumberOfPartitions(), 2u);
  for (unsigned int block = 0; block < 2; ++block)
  {
    vtkDataArray* errors = errorsOfLeft(grid, block);
    ASSERT_TRUE(errors);
    ASSERT_EQ(errors->GetNumberOfTuples(), block == 0 ? layer : 3 * layer);
    ASSERT_EQ(grid->GetPartition(block)->GetNumberOfCells(), errors->GetNumberOfTuples());
    EXPECT_GT(errors->GetRange()[1] - errors->GetRange()[0], 1e-4); // there is something to mix up
    for (vtkIdType cell = 0; cell < errors->GetNumberOfTuples(); ++cell)
    {
      EXPECT_NEAR(errors->GetTuple1(cell), whole->GetTuple1(cell + (block == 0 ? 0 : layer)), 1e-12);
    }
  }
}

TEST_F(VolumeErrors, HiddenCellsHaveNone)
{
  auto image = roughHalves();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    ghosts->InsertNextValue(cell < layer ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  image->GetCellData()->AddArray(ghosts);
  vtkDataArray* errors = errorsOfLeft(run(image), 0);
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(std::isnan(errors->GetTuple1(cell)), cell < layer);
  }
}

TEST_F(VolumeErrors, ThoseOfACurvedCellAreOfAllItsPieces)
{
  // A row of quadratic hexahedra with their corners and the middles of their edges, faces and bodies.
  constexpr double nodes[27][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 2, 0, 2 },
    { 2, 2, 2 }, { 0, 2, 2 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 }, { 0, 1, 0 }, { 1, 0, 2 }, { 2, 1, 2 }, { 1, 2, 2 },
    { 0, 1, 2 }, { 0, 0, 1 }, { 2, 0, 1 }, { 2, 2, 1 }, { 0, 2, 1 }, { 0, 1, 1 }, { 2, 1, 1 }, { 1, 0, 1 }, { 1, 2, 1 },
    { 1, 1, 0 }, { 1, 1, 2 }, { 1, 1, 1 } };
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> left;
  left->SetName("volume_fraction_left");
  vtkNew<vtkFloatArray> right;
  right->SetName("volume_fraction_right");
  for (int cell = 0; cell < 3; ++cell)
  {
    vtkNew<vtkIdList> ids;
    for (const auto& node : nodes)
    {
      const double bend = 0.1 * node[1] * (2.0 - node[1]); // cells that are straight are not cut
      ids->InsertNextId(points->InsertNextPoint(node[0] + 2.0 * cell + bend, node[1], node[2]));
    }
    grid->InsertNextCell(VTK_TRIQUADRATIC_HEXAHEDRON, ids);
    left->InsertNextValue(cell == 0 ? 1.0f : cell == 1 ? 0.3f : 0.0f);
    right->InsertNextValue(1.0f - left->GetValue(cell));
  }
  grid->SetPoints(points);
  grid->GetCellData()->AddArray(left);
  grid->GetCellData()->AddArray(right);
  vtkDataArray* errors = errorsOfLeft(run(grid), 0);
  ASSERT_EQ(errors->GetNumberOfTuples(), 3);
  EXPECT_GT(std::abs(totalError(0)), 1e-3);
  EXPECT_NEAR(errors->GetTuple1(0) + errors->GetTuple1(1) + errors->GetTuple1(2), totalError(0), 1e-12);
}
