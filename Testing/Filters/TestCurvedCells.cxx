#include "Conversion/DefaultField.h"
#include "Conversion/InputGrid.h"
#include "Conversion/ReadSimulation.h"
#include "CurvedTypes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace conversion = strata::conversion;
using strata::CellShape;
using strata::Index;
using strata::UnstructuredGrid;
using strata::Vector;

namespace
{
const UnstructuredGrid& gridOf(const conversion::InputGrid& input)
{
  return std::get<UnstructuredGrid>(input.grid);
}

/// How many faces of cells occur once, and the most often that one does.
std::pair<int, int> faceUses(const UnstructuredGrid& grid)
{
  static const std::map<CellShape, std::vector<std::vector<int>>> faces = {
    { CellShape::Tetrahedron, { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 2, 3 } } },
    { CellShape::Hexahedron,
      { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } } },
    { CellShape::Wedge, { { 0, 1, 2 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } } },
    { CellShape::Pyramid, { { 0, 1, 2, 3 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } } }
  };
  std::map<std::vector<Index>, int> uses;
  for (std::size_t cell = 0; cell < grid.shapes.size(); ++cell)
  {
    for (const std::vector<int>& face : faces.at(grid.shapes[cell]))
    {
      std::vector<Index> points;
      for (const int corner : face)
      {
        points.push_back(grid.corners[static_cast<std::size_t>(grid.cornerOffsets[cell] + corner)]);
      }
      std::sort(points.begin(), points.end());
      ++uses[points];
    }
  }
  std::pair<int, int> result;
  for (const auto& [points, count] : uses)
  {
    result.first += count == 1;
    result.second = std::max(result.second, count);
  }
  return result;
}

void addPointField(vtkUnstructuredGrid* grid, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("density");
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  grid->GetPointData()->AddArray(array);
}
}

TEST(CurvedCells, EveryTypeBecomesPiecesThatMatch)
{
  for (const CurvedType& kind : curvedTypes)
  {
    const conversion::InputGrid input = conversion::readGrid(oneCell(kind, bent));
    const UnstructuredGrid& grid = gridOf(input);
    EXPECT_EQ(grid.cellCount(), kind.pieces) << kind.name;
    const auto [outer, most] = faceUses(grid);
    EXPECT_EQ(outer, kind.boundaryFaces) << kind.name;
    EXPECT_LE(most, 2) << kind.name;
    EXPECT_TRUE(std::all_of(input.cellSource.begin(), input.cellSource.end(), [](Index s) { return s == 0; }));
  }
}

TEST(CurvedCells, PointsOfThePiecesLieWhereTheMapOfTheCellTakesThem)
{
  for (const CurvedType& kind : curvedTypes)
  {
    const bool interpolates = kind.type < VTK_BEZIER_CURVE; // Bezier control points don't lie on the map
    const bool complete = kind.type != VTK_QUADRATIC_PYRAMID && kind.type != VTK_TRIQUADRATIC_PYRAMID &&
                          kind.type != VTK_QUADRATIC_LINEAR_WEDGE; // these lack some quadratic functions
    if (!interpolates || !complete)
    {
      continue;
    }
    const conversion::InputGrid input = conversion::readGrid(oneCell(kind, bent));
    const double steps = kind.nodes == 10 || kind.pieces == 8 ? 2.0 : 3.0;
    for (const Vector& place : gridOf(input).points)
    {
      double nearest = 1.0;
      for (double r = 0.0; r <= steps; ++r)
      {
        for (double s = 0.0; s <= steps; ++s)
        {
          for (double t = 0.0; t <= steps; ++t)
          {
            nearest = std::min(nearest, (bent(Vector(r, s, t) / steps) - place).norm());
          }
        }
      }
      EXPECT_LT(nearest, 1e-12) << kind.name;
    }
  }
}

TEST(CurvedCells, StraightCellsStayWholeWhereNoFieldBends)
{
  for (const CurvedType& kind : curvedTypes)
  {
    const auto sheared = [](const Vector& p) { return Vector(p[0] + 0.1 * p[2], p[1], p[2]); };
    EXPECT_EQ(gridOf(conversion::readGrid(oneCell(kind, sheared))).cellCount(), 1) << kind.name;
  }
}

TEST(CurvedCells, AWrongNumberOfNodesIsNoReasonToReadBeyondThem)
{
  const CurvedType broken{ "hexahedron of 26 nodes", VTK_LAGRANGE_HEXAHEDRON, 26, 0, 0 };
  vtkNew<vtkUnstructuredGrid> grid;
  const auto whole = oneCell(curvedTypes[2], [](const Vector& p) { return p; });
  grid->SetPoints(whole->GetPoints());
  std::vector<vtkIdType> ids(static_cast<std::size_t>(broken.nodes));
  std::iota(ids.begin(), ids.end(), 0);
  grid->InsertNextCell(broken.type, broken.nodes, ids.data());
  const conversion::InputGrid input = conversion::readGrid(grid);
  EXPECT_EQ(cellCount(input.grid), 1);
  ASSERT_EQ(input.warnings.size(), 1u);
  EXPECT_NE(input.warnings.front().find("straight"), std::string::npos);
}

TEST(CurvedCells, EachMaterialKeepsItsValueAtPointsThatAreNotShared)
{
  // Two cells side by side, each with nodes of its own: density 1 in the first, 5 in the second.
  const auto grid = oneCell(curvedTypes[2], [](const Vector& p) { return p; });
  const auto second = oneCell(curvedTypes[2], [](const Vector& p) { return Vector(p + Vector(1.0, 0.0, 0.0)); });
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    ids.push_back(grid->GetPoints()->InsertNextPoint(second->GetPoint(i)));
  }
  grid->InsertNextCell(VTK_TRIQUADRATIC_HEXAHEDRON, 27, ids.data());
  std::vector<double> density(54, 1.0);
  std::fill(density.begin() + 27, density.end(), 5.0);
  addPointField(grid, density);
  vtkNew<vtkIntArray> material;
  material->SetName("material");
  material->InsertNextValue(1);
  material->InsertNextValue(2);
  grid->GetCellData()->AddArray(material);

  conversion::CaseData data;
  data.grid = grid;
  const conversion::ReadSimulationResult read = conversion::readSimulation(data, {});
  ASSERT_EQ(read.simulation.fields.size(), 1u);
  const auto& points = std::get<UnstructuredGrid>(read.simulation.grid).points;
  EXPECT_EQ(points.size(), 45u); // 9 are shared
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto at = static_cast<Index>(i);
    EXPECT_TRUE(points[i][0] > 1.0 + 1e-9 || read.simulation.fields[0].values[0](at) == 1.0);
    EXPECT_TRUE(points[i][0] < 1.0 - 1e-9 || read.simulation.fields[0].values[1](at) == 5.0);
  }
}

TEST(DefaultField, NamesOfThePhysicsComeBeforeMasses)
{
  const auto order = [](const char* name, bool ownArrays, bool mixed) {
    return conversion::defaultOrder({ name, ownArrays, mixed });
  };
  EXPECT_LT(order("density", true, true), order("pressure", false, true));
  EXPECT_LT(order("Pressure (dynes/cm^2^)", false, true), order("Temperature (eV)", false, true));
  EXPECT_LT(order("T", false, true), order("rho", false, true)) << "a mixture's density belongs to no material";
  EXPECT_LT(order("rho", false, false), order("p", false, false));
  EXPECT_LT(order("X Velocity", false, true), order("porosity", false, true));
  EXPECT_EQ(order("Mass for Armor Plate", true, true), conversion::lastDefaultOrder);
  EXPECT_EQ(order("mass_density", true, true), 0);
}
