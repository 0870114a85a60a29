#include "TwoHalves.h"

#include "vtkStrataMaterialInterfaces.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

using namespace strata::test;

namespace
{
constexpr int cells = 4;

/// The two halves as a curvilinear grid; left-handed if asked for.
vtkSmartPointer<vtkStructuredGrid> curvilinear(bool leftHanded)
{
  auto image = twoHalves(cells);
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(cells + 1, cells + 1, cells + 1);
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    points->InsertNextPoint(p[0], p[1], leftHanded ? 1.0 - p[2] : p[2]);
  }
  grid->SetPoints(points);
  grid->GetCellData()->ShallowCopy(image->GetCellData());
  return grid;
}

/// The same as an unstructured grid of voxels.
vtkSmartPointer<vtkUnstructuredGrid> voxels()
{
  auto image = twoHalves(cells);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(curvilinear(false)->GetPoints());
  grid->Allocate(image->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    image->GetCellPoints(cell, corners);
    grid->InsertNextCell(VTK_VOXEL, corners);
  }
  grid->GetCellData()->ShallowCopy(image->GetCellData());
  return grid;
}

/// The cells from `begin` to `end` along z, those below `begin + ghosts` marked as ghosts.
vtkSmartPointer<vtkImageData> slab(int begin, int end, int ghosts)
{
  auto image = twoHalves(cells);
  vtkNew<vtkUnsignedCharArray> ghost;
  ghost->SetName(vtkDataSetAttributes::GhostArrayName());
  ghost->SetNumberOfTuples(image->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    ghost->SetValue(cell, cell / (cells * cells) < begin + ghosts ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  image->GetCellData()->AddArray(ghost);
  cropAlongZ(image, begin, end);
  return image;
}

/// The reconstructed volume of `left`, which must be 1/2.
double volumeOfLeft(vtkDataObject* data)
{
  vtkNew<vtkStrataMaterialInterfaces> filter;
  filter->SetInputDataObject(data);
  EXPECT_EQ(update(filter).error, "");
  vtkDataArray* volumes = filter->GetOutputDataObject(0)->GetFieldData()->GetArray("volume_reconstructed");
  return volumes && volumes->GetNumberOfTuples() > 0 ? volumes->GetTuple1(0) : -1.0;
}
}

TEST(GridKinds, TheSameDataInAnyGridHasTheSameVolumes)
{
  EXPECT_NEAR(volumeOfLeft(twoHalves(cells)), 0.5, 1e-6);
  EXPECT_NEAR(volumeOfLeft(curvilinear(false)), 0.5, 1e-6);
  EXPECT_NEAR(volumeOfLeft(curvilinear(true)), 0.5, 1e-6);
  EXPECT_NEAR(volumeOfLeft(voxels()), 0.5, 1e-6);
}

TEST(GridKinds, ATurnedImageIsTaken)
{
  auto image = twoHalves(cells);
  image->SetDirectionMatrix(0, 0, 1, 1, 0, 0, 0, 1, 0);
  EXPECT_NEAR(volumeOfLeft(image), 0.5, 1e-6);
}

TEST(GridKinds, BlocksAreJoinedAndGhostCellsDropped)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, slab(0, 2, 0));
  blocks->SetBlock(1, slab(1, 4, 1)); // its first layer is that of block 0
  EXPECT_NEAR(volumeOfLeft(blocks), 0.5, 1e-6);
}

TEST(GridKinds, ABlockThatLacksAnArrayIsNamed)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, slab(0, 2, 0));
  auto other = slab(2, 4, 0);
  other->GetCellData()->RemoveArray("volume_fraction_left");
  blocks->SetBlock(1, other);
  vtkNew<vtkStrataMaterialInterfaces> filter;
  filter->SetInputDataObject(blocks);
  EXPECT_REFUSED(filter, "volume_fraction_left", "block '2'", "missing");
}
