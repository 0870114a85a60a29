#include "TwoHalves.h"

#include "vtkStrataMaterialInterfaces.h"
#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <initializer_list>
#include <limits>
#include <vector>

using namespace strata::test;

namespace
{
using Coordinates = std::vector<std::array<double, 3>>;

/// One cell of a type over the given points.
vtkSmartPointer<vtkUnstructuredGrid> oneCell(int type, const Coordinates& coordinates, std::vector<vtkIdType> corners)
{
  vtkNew<vtkPoints> points;
  for (const auto& p : coordinates)
  {
    points->InsertNextPoint(p.data());
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  vtkNew<vtkUnsignedCharArray> types;
  types->InsertNextValue(static_cast<unsigned char>(type));
  grid->SetCells(types, cells);
  return grid;
}

const Coordinates unitCorner = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

vtkSmartPointer<vtkStrataTetrahedra> filterOf(vtkDataObject* data)
{
  auto filter = vtkSmartPointer<vtkStrataTetrahedra>::New();
  filter->SetInputDataObject(data);
  filter->SetMaximumLevel(3);
  return filter;
}

void hide(vtkImageData* image, std::initializer_list<vtkIdType> cells)
{
  vtkUnsignedCharArray* ghosts = image->AllocateCellGhostArray();
  for (const vtkIdType cell : cells)
  {
    ghosts->SetValue(cell, vtkDataSetAttributes::HIDDENCELL);
  }
}
}

TEST(BadGrids, EmptyAndFlatGridsAreRefused)
{
  EXPECT_REFUSED(filterOf(vtkNew<vtkImageData>()), "points");
  EXPECT_REFUSED(filterOf(vtkNew<vtkUnstructuredGrid>()), "no visible cells");
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(5, 5, 1);
  EXPECT_REFUSED(filterOf(flat), "5 x 5 x 1");
}

TEST(BadGrids, AGridOfOneCellIsFine)
{
  auto image = twoHalves(1);
  auto filter = filterOf(image);
  EXPECT_EQ(update(filter).error, "");
  EXPECT_GE(cellsOf(filter), 6);
}

TEST(BadGrids, SpacingMustBePositive)
{
  for (const double spacing : { 0.0, -0.5, std::numeric_limits<double>::quiet_NaN() })
  {
    auto image = twoHalves(2);
    image->SetSpacing(1.0, spacing, 1.0);
    EXPECT_REFUSED(filterOf(image), "along y", "ascend");
  }
}

TEST(BadGrids, CoordinatesMustFitTheExtent)
{
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(3, 2, 2);
  vtkNew<vtkDoubleArray> two;
  two->InsertNextValue(0.0);
  two->InsertNextValue(1.0);
  grid->SetXCoordinates(two);
  grid->SetYCoordinates(two);
  grid->SetZCoordinates(two);
  EXPECT_REFUSED(filterOf(grid), "2 coordinates along x", "3");
}

TEST(BadGrids, HiddenCellsAreOutside)
{
  auto image = twoHalves(4);
  hide(image, { 0, 1 });
  auto filter = filterOf(image);
  EXPECT_EQ(update(filter).error, "");
  auto* names = filter->GetOutputDataObject(0)->GetFieldData()->GetAbstractArray("material_names");
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  EXPECT_EQ(names->GetVariantValue(2).ToString(), "outside");
}

TEST(BadGrids, AGridWithoutVisibleCellsIsRefused)
{
  auto image = twoHalves(2);
  hide(image, { 0, 1, 2, 3, 4, 5, 6, 7 });
  EXPECT_REFUSED(filterOf(image), "hidden");
}

TEST(BadGrids, BadCellsAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(update(filterOf(oneCell(VTK_TETRA, unitCorner, { 0, 1, 2, 3 }))).error, "");
  EXPECT_REFUSED(filterOf(oneCell(VTK_TETRA, unitCorner, { 0, 2, 1, 3 })), "cell 0", "inverted");
  EXPECT_REFUSED(filterOf(oneCell(VTK_TETRA, unitCorner, { 0, 1, 2, 2 })), "cell 0", "degenerate");
  EXPECT_REFUSED(filterOf(oneCell(VTK_TETRA, unitCorner, { 0, 1, 2, 9 })), "Cell 0", "point 9");
  EXPECT_REFUSED(filterOf(oneCell(VTK_TETRA, unitCorner, { 0, 1, 2, -1 })), "Cell 0", "point -1");
  EXPECT_REFUSED(filterOf(oneCell(99, unitCorner, { 0, 1, 2, 3 })), "Cell 0", "type 99");
  EXPECT_REFUSED(filterOf(oneCell(VTK_HEXAHEDRON, unitCorner, { 0, 1, 2, 3 })), "Cell 0", "4 points");
  EXPECT_REFUSED(filterOf(oneCell(VTK_TETRA, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, nan, 0 }, { 0, 0, 1 } }, { 0, 1, 2, 3 })),
    "cell 0", "not finite");
  EXPECT_REFUSED(filterOf(oneCell(VTK_TRIANGLE, unitCorner, { 0, 1, 2 })), "no visible cells");
}

TEST(BadGrids, BadAndRepeatedCellsAreLeftOutAndTheOthersUsed)
{
  const Coordinates corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
  const std::array<std::array<vtkIdType, 4>, 5> cells = { { { 0, 1, 2, 3 }, { 0, 2, 1, 3 }, { 1, 2, 3, 4 },
    { 0, 1, 2, 2 }, { 4, 2, 1, 3 } } };
  auto grid = oneCell(VTK_TETRA, corners, { 0, 1, 2, 3 });
  for (std::size_t c = 1; c < cells.size(); ++c)
  {
    grid->InsertNextCell(VTK_TETRA, 4, cells[c].data());
  }
  auto filter = filterOf(grid);
  const auto said = update(filter);
  EXPECT_EQ(said.error, "");
  EXPECT_NE(said.warning.find("cell 1 is -"), std::string::npos) << said.warning;
  EXPECT_NE(said.warning.find("inverted or without volume: 2"), std::string::npos) << said.warning;
  EXPECT_NE(said.warning.find("cell 4 has the corners of cell 2"), std::string::npos) << said.warning;
  EXPECT_GT(filter->GetOutput()->GetNumberOfElements(vtkDataObject::CELL), 0);
}

TEST(BadGrids, SurfacesAreNoSimulations)
{
  vtkNew<vtkPolyData> surface;
  EXPECT_REFUSED(filterOf(surface), "surface");
}

TEST(BadGrids, ArraysThatAreTooShortAreNamed)
{
  auto image = twoHalves(2);
  cellArray(image, "volume_fraction_left")->SetNumberOfTuples(3);
  EXPECT_REFUSED(filterOf(image), "volume_fraction_left", "3 values for 8 cells");
}
