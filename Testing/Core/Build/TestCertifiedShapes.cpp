#include "CertifiedCells.h"

#include "../Native/UnstructuredGrids.h"
#include "Build/ParametricCut.h"
#include "Model/Errors.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

namespace strata
{
namespace
{
using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Rounding must not exclude points on faces.
constexpr double skin = 1e-13;

/// Random data on warped cells of one shape, all of one material.
Simulation randomSimulation(
  CellShape shape, int components, unsigned seed, Association association = Association::Points)
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
  SimulationField field{ "noise", components, association, {} };
  const Index tuples = association == Association::Cells ? grid.cellCount() : grid.pointCount();
  std::vector<double> values(static_cast<std::size_t>(tuples * components));
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

/// A native cell as a function of parameters in the unit cube, of which a tetrahedron uses those whose sum is at
/// most 1.
class NativeFunction
{
public:
  NativeFunction(const NativeData& native, NativeCellIndex index) :
    cell_(native.nativeCell(index)), components_(static_cast<std::size_t>(native.fields()[0].components)),
    values_(8 * components_)
  {
    native.values(FieldId(0), MaterialId(0), cell_.samples.data(), 8, values_.data());
    std::for_each(
      cell_.corners.begin(), cell_.corners.begin() + cell_.cornerCount(), [&](const Vector& p) { box_.add(p); });
  }

  const Box& box() const { return box_; }
  Vector place(const Vector& u) const
  {
    const std::array<double, 8> w = weights(u);
    Vector p = Vector::Zero();
    for (std::size_t k = 0; k < 8; ++k)
    {
      p += w[k] * cell_.corners[k];
    }
    return p;
  }
  double value(const Vector& u, std::size_t component) const
  {
    const std::array<double, 8> w = weights(u);
    double sum = 0.0;
    for (std::size_t k = 0; k < 8; ++k)
    {
      sum += w[k] * values_[k * components_ + component];
    }
    return sum;
  }
  std::size_t componentCount() const { return components_; }
  bool contains(const Vector& u) const
  {
    return u.minCoeff() >= -skin && (isTetrahedron() ? u.sum() : u.maxCoeff()) <= 1.0 + skin;
  }

  /// Often on faces and edges.
  Vector randomParameters(std::mt19937& random) const
  {
    if (isTetrahedron())
    {
      const std::array<double, 4> w = randomWeights(random);
      return { w[1], w[2], w[3] };
    }
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Vector u;
    for (double& x : u)
    {
      const auto kind = random() % 6;
      x = kind < 2 ? static_cast<double>(kind) : unit(random);
    }
    return u;
  }

  /// Parameters near those of a point (its own but for rounding), by Newton's method.
  Vector parametersNear(const Vector& p) const
  {
    Vector u = Vector::Constant(0.3);
    for (int i = 0; i < 8; ++i)
    {
      Eigen::Matrix3d slopes;
      for (int axis = 0; axis < 3; ++axis)
      {
        // The place is linear along each axis.
        Vector ahead = u;
        ahead[axis] += 1.0;
        slopes.col(axis) = place(ahead) - place(u);
      }
      u += slopes.inverse() * (p - place(u));
    }
    return u;
  }

private:
  bool isTetrahedron() const { return cell_.kind == NativeCell::Kind::Tetrahedron; }
  std::array<double, 8> weights(const Vector& u) const
  {
    if (isTetrahedron())
    {
      return { 1.0 - u.sum(), u[0], u[1], u[2], 0.0, 0.0, 0.0, 0.0 };
    }
    std::array<double, 8> result;
    for (std::size_t i = 0; i < 8; ++i)
    {
      result[i] =
        ((i & 1) != 0 ? u[0] : 1.0 - u[0]) * ((i & 2) != 0 ? u[1] : 1.0 - u[1]) * ((i & 4) != 0 ? u[2] : 1.0 - u[2]);
    }
    return result;
  }

  NativeCell cell_;
  std::size_t components_;
  std::vector<double> values_;
  Box box_;
};

/// The difference between native cells and a cell, seen at random points that lie in both.
class SeenError
{
public:
  SeenError(const NativeData& native, const Hierarchy& hierarchy, CellId cell) :
    corners_(cornerPositions(hierarchy, cell)), barycentric_(corners_)
  {
    const MaterialCorners corners = materialCorners(hierarchy, hierarchy.cell(cell), MaterialId(0));
    for (int c = 0; c < native.fields()[0].components; ++c)
    {
      represented_.push_back(representedFunction(barycentric_, corners, 1 + c));
    }
    for (NativeCellIndex n = 0; n < native.nativeCellCount(); ++n)
    {
      const NativeFunction function(native, n);
      if ((function.box().lower.array() <= barycentric_.box.upper.array()).all() &&
          (function.box().upper.array() >= barycentric_.box.lower.array()).all())
      {
        functions_.push_back(function);
      }
    }
  }

  /// The largest difference at so many points: every other one starts from the cell, the others from native cells.
  double largestAt(int points, std::mt19937& random)
  {
    for (int i = 0; seen_ < points; ++i)
    {
      const NativeFunction& function = functions_[random() % functions_.size()];
      if (i % 2 == 0)
      {
        look(function, function.randomParameters(random));
        continue;
      }
      const Vector p = pointAt(corners_, randomWeights(random));
      for (const NativeFunction& holder : functions_)
      {
        if (holder.box().contains(p))
        {
          look(holder, holder.parametersNear(p));
        }
      }
    }
    return std::sqrt(largest2_);
  }

private:
  void look(const NativeFunction& function, const Vector& u)
  {
    if (!function.contains(u))
    {
      return;
    }
    const Vector p = function.place(u);
    if (!barycentric_.contains(p, skin))
    {
      return;
    }
    ++seen_;
    double squared = 0.0;
    for (std::size_t c = 0; c < function.componentCount(); ++c)
    {
      squared += std::pow(function.value(u, c) - represented_[c](p), 2);
    }
    largest2_ = std::max(largest2_, squared);
  }

  std::array<Vector, 4> corners_;
  Barycentric barycentric_;
  std::vector<LinearFunction> represented_;
  std::vector<NativeFunction> functions_;
  int seen_ = 0;
  double largest2_ = 0.0;
};

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

TEST_P(CertifiedShapes, NoneOfTenThousandPointsExceedsTheBoundAndTheBoundIsTight)
{
  const auto native = readNative(randomSimulation(GetParam().shape, GetParam().components, 2));
  const CertifiedCells cells(native, {}, { infinity, { 0.3 } }, 12);
  std::mt19937 random(3);
  double sumOfRatios = 0.0;
  double smallestRatio = infinity;
  constexpr int count = 20;
  for (const CellId cell : randomCells(cells.hierarchy(), count, 4))
  {
    const double seen = SeenError(*native, cells.hierarchy(), cell).largestAt(10000, random);
    const auto bound = static_cast<double>(cells.hierarchy().fieldError(cell, 0));
    ASSERT_GE(bound, seen) << "cell " << cell.value;
    sumOfRatios += bound / seen;
    smallestRatio = std::min(smallestRatio, bound / seen);
  }
  RecordProperty("MeanOfBoundOverSeen", std::to_string(sumOfRatios / count));
  EXPECT_LE(sumOfRatios / count, 1.2);
  // A bound one per cent lower would be exceeded.
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

class CertifiedCellData : public testing::TestWithParam<CellShape>
{
};

INSTANTIATE_TEST_SUITE_P(EveryShape, CertifiedCellData,
  testing::Values(
    CellShape::Tetrahedron, CellShape::Hexahedron, CellShape::Wedge, CellShape::Pyramid, CellShape::Polyhedron));

TEST_P(CertifiedCellData, TheBoundIsTheLargestErrorAtTheCentresOfVolume)
{
  const auto native = readNative(randomSimulation(GetParam(), 1, 6, Association::Cells));
  const CertifiedCells cells(native, {}, { infinity, { 0.3 } }, 12);
  int count = 0;
  for (Index c = 0; c < cells.cellCount(); ++c)
  {
    const CellId cell(c);
    const Barycentric barycentric(cornerPositions(cells.hierarchy(), cell));
    const MaterialCorners corners = materialCorners(cells.hierarchy(), cells.hierarchy().cell(cell), MaterialId(0));
    const LinearFunction represented = representedFunction(barycentric, corners, 1);
    double largest = 0.0;
    for (SampleIndex sample = 0; sample < native->sampleCount(); ++sample)
    {
      Vector p;
      double value = 0.0;
      native->positions(&sample, 1, &p);
      native->values(FieldId(0), MaterialId(0), &sample, 1, &value);
      largest = barycentric.contains(p, 0.0) ? std::max(largest, std::abs(value - represented(p))) : largest;
    }
    const auto bound = static_cast<double>(cells.hierarchy().fieldError(cell, 0));
    EXPECT_GE(bound, largest - 1e-12);
    // Samples within rounding of a face count for both cells.
    EXPECT_LT(0.99 * bound, largest + 1e-6);
    count += largest > 0.0 ? 1 : 0;
  }
  EXPECT_GT(count, 30);
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
