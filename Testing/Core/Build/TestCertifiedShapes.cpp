#include "CertifiedCells.h"

#include "../Native/UnstructuredGrids.h"
#include "Build/ParametricCut.h"
#include "Model/Errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace strata
{
namespace
{
using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Random point data on warped cells of one shape, all of one material.
Simulation randomSimulation(CellShape shape, int components, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  UnstructuredGrid grid = unstructured(cubeGrid(3), shape);
  for (Vector& p : grid.points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // Points on the walls of the cube stay on them.
      p[axis] += p[axis] > 0.0 && p[axis] < 1.0 ? 0.05 * unit(random) : 0.0;
    }
  }
  Simulation simulation;
  simulation.materials = namedMaterials(1);
  simulation.materialIds.assign(static_cast<std::size_t>(grid.cellCount()), 0);
  SimulationField field{ "noise", components, Association::Points, {} };
  std::vector<double> values(grid.points.size() * static_cast<std::size_t>(components));
  std::generate(values.begin(), values.end(), [&] { return unit(random); });
  field.values = { ownedArray(std::move(values), components) };
  simulation.fields = { field };
  simulation.grid = std::move(grid);
  return simulation;
}

std::shared_ptr<const NativeData> readNative(const Simulation& simulation)
{
  Progress progress;
  return readNativeData(simulation, {}, progress);
}

/// Weights of the corners of a native cell at a random point, often on its faces and edges.
std::array<double, 8> randomWeightsIn(const NativeCell& cell, std::mt19937& random)
{
  std::array<double, 8> weights{};
  if (cell.kind == NativeCell::Kind::Tetrahedron)
  {
    const std::array<double, 4> four = randomWeights(random);
    std::copy(four.begin(), four.end(), weights.begin());
    return weights;
  }
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::array<double, 3> u;
  for (double& x : u)
  {
    const auto kind = random() % 6;
    x = kind < 2 ? static_cast<double>(kind) : unit(random);
  }
  for (std::size_t i = 0; i < 8; ++i)
  {
    weights[i] =
      ((i & 1) != 0 ? u[0] : 1.0 - u[0]) * ((i & 2) != 0 ? u[1] : 1.0 - u[1]) * ((i & 4) != 0 ? u[2] : 1.0 - u[2]);
  }
  return weights;
}

/// The largest |native - represented| at random points of native cells that lie in a cell.
double seenError(const NativeData& native, const Hierarchy& hierarchy, CellId cell, std::mt19937& random)
{
  const auto components = static_cast<std::size_t>(native.fields()[0].components);
  const Barycentric barycentric(cornerPositions(hierarchy, cell));
  const MaterialCorners corners = materialCorners(hierarchy, hierarchy.cell(cell), MaterialId(0));
  double largest2 = 0.0;
  for (NativeCellIndex n = 0; n < native.nativeCellCount(); ++n)
  {
    const NativeCell element = native.nativeCell(n);
    std::vector<double> values(8 * components);
    native.values(FieldId(0), MaterialId(0), element.samples.data(), 8, values.data());
    for (int i = 0; i < 1500; ++i)
    {
      const std::array<double, 8> weights = randomWeightsIn(element, random);
      Vector p = Vector::Zero();
      for (std::size_t k = 0; k < 8; ++k)
      {
        p += weights[k] * element.corners[k];
      }
      if (!barycentric.contains(p, 0.0))
      {
        continue;
      }
      double squared = 0.0;
      for (std::size_t c = 0; c < components; ++c)
      {
        double difference = -representedFunction(barycentric, corners, 1 + static_cast<int>(c))(p);
        for (std::size_t k = 0; k < 8; ++k)
        {
          difference += weights[k] * values[k * components + c];
        }
        squared += difference * difference;
      }
      largest2 = std::max(largest2, squared);
    }
  }
  return std::sqrt(largest2);
}

struct Kind
{
  CellShape shape;
  int components;
};

class CertifiedShapes : public testing::TestWithParam<Kind>
{
};

INSTANTIATE_TEST_SUITE_P(EveryShape, CertifiedShapes,
  testing::Values(Kind{ CellShape::Tetrahedron, 1 }, Kind{ CellShape::Tetrahedron, 3 },
    Kind{ CellShape::Hexahedron, 1 }, Kind{ CellShape::Hexahedron, 3 }, Kind{ CellShape::Wedge, 1 },
    Kind{ CellShape::Pyramid, 1 }));

TEST_P(CertifiedShapes, NoPointExceedsTheBoundAndTheBoundIsTight)
{
  const auto native = readNative(randomSimulation(GetParam().shape, GetParam().components, 2));
  const CertifiedCells cells(native, {}, { infinity, { 0.3 } }, 12);
  std::mt19937 random(3);
  double sumOfRatios = 0.0;
  double smallestRatio = infinity;
  int count = 0;
  for (const CellId cell : randomCells(cells.hierarchy(), 20, 4))
  {
    const double seen = seenError(*native, cells.hierarchy(), cell, random);
    const auto bound = static_cast<double>(cells.hierarchy().fieldError(cell, 0));
    ASSERT_GE(bound, seen) << "cell " << cell.value;
    if (cells.hierarchy().cell(cell).level <= 8)
    {
      // In smaller ones, few of the points lie.
      sumOfRatios += bound / seen;
      smallestRatio = std::min(smallestRatio, bound / seen);
      ++count;
    }
  }
  EXPECT_GT(count, 5);
  EXPECT_LE(sumOfRatios / count, 1.2);
  EXPECT_LT(0.99 * smallestRatio, 1.0);
}

TEST_P(CertifiedShapes, RefinementMeetsABoundFarBelowTheJumpsBetweenSamples)
{
  const auto native = readNative(randomSimulation(GetParam().shape, GetParam().components, 5));
  const CertifiedCells cells(native, {}, { infinity, { 0.5 } }, 40);
  for (Index c = 0; c < cells.cellCount(); ++c)
  {
    if (!cells.hierarchy().cell(CellId(c)).firstChild.valid())
    {
      EXPECT_LE(cells.hierarchy().fieldError(CellId(c), 0), 0.5f);
      EXPECT_LT(cells.hierarchy().cell(CellId(c)).level, 30);
    }
  }
}

TEST(CertifiedShapes, PointDataOnPolyhedraAreRefusedByName)
{
  const auto native = readNative(randomSimulation(CellShape::Polyhedron, 1, 1));
  try
  {
    CertifiedCells(native, {}, { infinity, { 1.0 } }, 3);
    FAIL() << "polyhedra were taken";
  }
  catch (const InvalidInput& error)
  {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("polyhedra: cell 0"));
  }
}

TEST(HexahedronCut, ACellWithinAMuchLargerHexahedronGetsATightBound)
{
  // A field that is linear but for a bilinear term, on the unit cube; a cell a thousandth of its size.
  std::array<Vector, 8> corners;
  CornerNumbers values;
  for (std::size_t i = 0; i < 8; ++i)
  {
    corners[i] = Vector(static_cast<double>(i & 1), static_cast<double>((i >> 1) & 1), static_cast<double>(i >> 2));
    values[i] = corners[i].x() * corners[i].y();
  }
  const Vector a(0.5, 0.5, 0.5);
  const Barycentric barycentric(
    { a, a + Vector(0.001, 0, 0), a + Vector(0.001, 0.001, 0), a + Vector(0.001, 0.001, 0.001) });
  // x y is largest at the far corners.
  const HexahedronCut::Bounds bounds = HexahedronCut(barycentric, corners).largestLength({ values }, 0.0, 1000);
  EXPECT_GE(bounds.upper, 0.501 * 0.501);
  EXPECT_LE(bounds.upper, 1.2 * 0.501 * 0.501);
  EXPECT_LE(bounds.reached, 0.501 * 0.501 * (1.0 + 1e-9));
  EXPECT_GE(bounds.reached, bounds.upper / 1.2 * (1.0 - 1e-9));
}
}
}
