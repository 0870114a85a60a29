#include "TwoHalves.h"

#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkUnstructuredGrid.h>

using namespace strata::test;

namespace
{
struct InterestInMaterials : testing::Test
{
  InterestInMaterials()
  {
    filter->SetInputData(twoWaves(16));
    filter->SetInterfaceErrorBound(0.02);
    filter->SetFieldErrorBound(0.05);
  }
  vtkIdType cellsNow(const char* when)
  {
    EXPECT_EQ(update(filter).error, "") << when;
    return cellsOf(filter);
  }
  /// The number of cells whose bounds touch a box.
  vtkIdType cellsTouching(const double (&box)[6])
  {
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
    vtkIdType count = 0;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      double b[6];
      mesh->GetCellBounds(cell, b);
      bool touches = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        touches = touches && b[2 * axis] < box[2 * axis + 1] && b[2 * axis + 1] > box[2 * axis];
      }
      count += touches ? 1 : 0;
    }
    return count;
  }

  vtkNew<vtkStrataTetrahedra> filter;
};
}

TEST_F(InterestInMaterials, AFocusLeavesTheOtherMaterialCoarser)
{
  const double left[6] = { 0.0, 0.3, 0.0, 1.0, 0.0, 1.0 };
  const double right[6] = { 0.7, 1.0, 0.0, 1.0, 0.0, 1.0 };
  const vtkIdType all = cellsNow("without a focus");
  const vtkIdType allLeft = cellsTouching(left);
  const vtkIdType allRight = cellsTouching(right);
  filter->AddFocusMaterial("left");
  ASSERT_EQ(update(filter).error, "");
  EXPECT_LT(cellsOf(filter), all);
  EXPECT_EQ(cellsTouching(left), allLeft);
  EXPECT_LT(cellsTouching(right), allRight);
  filter->ClearFocusMaterials();
  EXPECT_EQ(cellsNow("after the focus"), all);
  EXPECT_EQ(filter->GetNumberOfBuilds(), 1);
}

TEST_F(InterestInMaterials, AFocusOnAnUnknownMaterialNamesItAndTheKnownOnes)
{
  filter->AddFocusMaterial("middle");
  EXPECT_REFUSED(filter, "'middle'", "left", "right");
}

TEST_F(InterestInMaterials, OutsideARegionTheMeshIsCoarser)
{
  const double corner[6] = { 0.0, 0.2, 0.0, 0.2, 0.0, 0.2 };
  const vtkIdType all = cellsNow("without a region");
  const vtkIdType allInCorner = cellsTouching(corner);
  filter->SetRegionOfInterest(vtkStrataTetrahedra::BOX);
  filter->SetRegionBounds(corner);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_LT(cellsOf(filter), all);
  EXPECT_EQ(cellsTouching(corner), allInCorner);
  filter->SetRegionOfInterest(vtkStrataTetrahedra::SPHERE);
  filter->SetRegionCenter(0.1, 0.1, 0.1);
  filter->SetRegionRadius(0.2);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_LT(cellsOf(filter), all);
  EXPECT_EQ(cellsTouching(corner), allInCorner);
  filter->SetRegionCoarsening(1.0);
  EXPECT_EQ(cellsNow("without coarsening"), all);
}

TEST_F(InterestInMaterials, RegionsThatMakeNoSenseAreRefused)
{
  filter->SetRegionOfInterest(vtkStrataTetrahedra::BOX);
  filter->SetRegionBounds(0.0, 1.0, 0.5, 0.25, 0.0, 1.0);
  EXPECT_REFUSED(filter, "RegionBounds", "0.5", "along y");
  filter->SetRegionOfInterest(vtkStrataTetrahedra::SPHERE);
  filter->SetRegionRadius(0.0);
  EXPECT_REFUSED(filter, "RegionRadius", "0");
  filter->SetRegionRadius(1.0);
  filter->SetRegionCoarsening(0.5);
  EXPECT_REFUSED(filter, "RegionCoarsening", "0.5");
}

TEST_F(InterestInMaterials, WhatTheCameraDoesNotSeeStaysCoarse)
{
  const vtkIdType all = cellsNow("without a view");
  filter->ViewDependentOn();
  filter->SetCameraPosition(0.5, 0.5, 5.0);
  filter->SetCameraFocalPoint(0.5, 0.5, 0.5);
  filter->SetPixelErrorBound(0.01);
  ASSERT_EQ(update(filter).error, "");
  const vtkIdType seen = cellsOf(filter);
  EXPECT_EQ(seen, all);
  filter->SetCameraFocalPoint(0.5, 0.5, 9.0);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_EQ(cellsOf(filter), 6) << "nothing is seen: the base mesh";
  EXPECT_EQ(filter->GetNumberOfBuilds(), 1);
}

TEST_F(InterestInMaterials, CamerasThatMakeNoSenseAreRefused)
{
  filter->ViewDependentOn();
  filter->SetCameraPosition(1.0, 2.0, 3.0);
  filter->SetCameraFocalPoint(1.0, 2.0, 3.0);
  EXPECT_REFUSED(filter, "position and focal point");
  filter->SetCameraFocalPoint(0.0, 0.0, 0.0);
  filter->SetCameraViewAngle(190.0);
  EXPECT_REFUSED(filter, "view angle", "190");
}
