#include "CertifiedCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace strata
{
namespace
{
using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Random values in a ball (material 0) and round it (material 1): no two neighbours are alike.
class RandomData
{
public:
  RandomData(Association association, int components, unsigned seed) :
    association_(association), components_(components)
  {
    SphereCase sphere = sphereCase(7, 3, wavyField);
    interfaces = sphere.interfaces;
    auto& grid = std::get<RectilinearGrid>(sphere.simulation.grid);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (std::vector<double>& axis : grid.coordinates)
    {
      for (std::size_t i = 1; i + 1 < axis.size(); ++i)
      {
        axis[i] += 0.03 * unit(random);
      }
    }
    grid_ = grid;
    SimulationField field;
    field.name = "noise";
    field.components = components;
    field.association = association;
    const Index count = association == Association::Cells ? grid.cellCount() : grid.pointCount();
    for (std::size_t m = 0; m < 2; ++m)
    {
      std::vector<double> values(static_cast<std::size_t>(count * components));
      std::generate(values.begin(), values.end(), [&] { return unit(random); });
      field.values.push_back(ownedArray(std::move(values), components));
    }
    values_ = field.values;
    sphere.simulation.fields = { field };
    Progress progress;
    native = readNativeData(sphere.simulation, {}, progress);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::vector<double>& x = grid_.coordinates[axis];
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
      {
        lattice_[axis].push_back(association == Association::Cells ? 0.5 * (x[i] + x[i + 1]) : x[i]);
      }
      if (association == Association::Points)
      {
        lattice_[axis].push_back(x.back());
      }
    }
  }

  /// The length of native - represented at a point, where the eight samples round it all count for m.
  std::optional<double> difference(MaterialId m, const Vector& p, const std::vector<double>& represented) const
  {
    std::array<std::size_t, 3> lower;
    std::array<double, 3> t;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::vector<double>& x = lattice_[axis];
      const double at = p[static_cast<Index>(axis)];
      if (at < x.front() || at > x.back())
      {
        return {};
      }
      lower[axis] = std::min<std::size_t>(
        static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin()) - 1, x.size() - 2);
      t[axis] = (at - x[lower[axis]]) / (x[lower[axis] + 1] - x[lower[axis]]);
    }
    std::vector<double> value(static_cast<std::size_t>(components_), 0.0);
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const std::size_t i = lower[0] + (corner & 1);
      const std::size_t j = lower[1] + ((corner >> 1) & 1);
      const std::size_t k = lower[2] + (corner >> 2);
      const auto sample = static_cast<SampleIndex>(i + lattice_[0].size() * (j + lattice_[1].size() * k));
      MaterialSet set;
      native->materialsAt(&sample, 1, &set);
      if (!set.contains(m))
      {
        return {};
      }
      const double weight = ((corner & 1) != 0 ? t[0] : 1.0 - t[0]) * ((corner & 2) != 0 ? t[1] : 1.0 - t[1]) *
                            ((corner & 4) != 0 ? t[2] : 1.0 - t[2]);
      for (int c = 0; c < components_; ++c)
      {
        value[static_cast<std::size_t>(c)] += weight * values_[static_cast<std::size_t>(m.value)](sample, c);
      }
    }
    double squared = 0.0;
    for (std::size_t c = 0; c < value.size(); ++c)
    {
      squared += std::pow(value[c] - represented[c], 2);
    }
    return std::sqrt(squared);
  }

  std::shared_ptr<const NativeData> native;
  Interfaces interfaces;

private:
  Association association_;
  int components_;
  RectilinearGrid grid_;
  std::vector<ValueArray> values_;
  std::array<std::vector<double>, 3> lattice_;
};

/// Values that a cell represents of one material at a point.
std::vector<double> representedAt(
  const Hierarchy& hierarchy, CellId cell, MaterialId m, const std::array<double, 4>& weights)
{
  const MaterialCorners corners = materialCorners(hierarchy, hierarchy.cell(cell), m);
  std::vector<double> result;
  for (int i = 1; i < hierarchy.valuesPerMaterial; ++i)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      sum += weights[k] * static_cast<double>(corners[k][i]);
    }
    result.push_back(sum);
  }
  return result;
}

/// The largest error that samples and random points of a cell show.
double seenError(const RandomData& data, const Hierarchy& hierarchy, CellId cell, std::mt19937& random)
{
  const std::array<Vector, 4> corners = cornerPositions(hierarchy, cell);
  const Barycentric barycentric(corners);
  double largest = 0.0;
  const auto look = [&](const Vector& p, const std::array<double, 4>& weights, MaterialSet materials) {
    for (const MaterialId m : materials& hierarchy.materialsOf(cell))
    {
      const std::vector<double> represented = representedAt(hierarchy, cell, m, weights);
      largest = std::max(largest, data.difference(m, p, represented).value_or(0.0));
    }
  };
  for (int i = 0; i < 10000; ++i)
  {
    const std::array<double, 4> weights = randomWeights(random);
    look(pointAt(corners, weights), weights, hierarchy.materialsOf(cell));
  }
  for (SampleIndex s = 0; s < data.native->sampleCount(); ++s)
  {
    Vector p;
    MaterialSet set;
    data.native->positions(&s, 1, &p);
    data.native->materialsAt(&s, 1, &set);
    if (barycentric.contains(p, 0.0))
    {
      look(p,
        { barycentric.weights[0](p), barycentric.weights[1](p), barycentric.weights[2](p), barycentric.weights[3](p) },
        set);
    }
  }
  return largest;
}

struct Kind
{
  Association association;
  int components;
  double factor; ///< of the bound over what is seen, on average
};

class CertifiedFieldsOn : public testing::TestWithParam<Kind>
{
};

INSTANTIATE_TEST_SUITE_P(EveryKind, CertifiedFieldsOn,
  testing::Values(
    Kind{ Association::Cells, 1, 1.2 }, Kind{ Association::Points, 1, 1.2 }, Kind{ Association::Points, 3, 1.25 }));

TEST_P(CertifiedFieldsOn, NoPointExceedsTheBoundAndTheBoundIsTight)
{
  const RandomData data(GetParam().association, GetParam().components, 3);
  // Interior cells of the hierarchy have bounds too: all levels are looked at.
  const CertifiedCells cells(data.native, data.interfaces, { infinity, { 0.35 } }, 18);
  std::mt19937 random(5);
  double sumOfRatios = 0.0;
  double smallestRatio = infinity;
  int count = 0;
  for (const CellId cell : randomCells(cells.hierarchy(), 60, 7))
  {
    const double seen = seenError(data, cells.hierarchy(), cell, random);
    const auto bound = static_cast<double>(cells.hierarchy().fieldError(cell, 0));
    ASSERT_GE(bound, seen) << "cell " << cell.value;
    if (seen > 1e-3)
    {
      sumOfRatios += bound / seen;
      smallestRatio = std::min(smallestRatio, bound / seen);
      ++count;
    }
  }
  RecordProperty("MeanOfBoundOverSeen", std::to_string(sumOfRatios / count));
  EXPECT_GT(count, 30);
  EXPECT_LE(sumOfRatios / count, GetParam().factor);
  // A bound one per cent lower would be exceeded.
  EXPECT_LT(0.99 * smallestRatio, 1.0);
}

TEST(CertifiedFields, SeeErrorsBetweenSamplesThatPointsMiss)
{
  const RandomData data(Association::Points, 1, 4);
  const ErrorBounds bounds = { infinity, { 0.35 } };
  const CertifiedCells certified(data.native, data.interfaces, bounds, 12);
  const CertifiedCells points(data.native, data.interfaces, bounds, 12, NativeElements::Points);
  ASSERT_GE(certified.cellCount(), points.cellCount());
  for (Index c = 0; c < 6; ++c)
  {
    EXPECT_GE(certified.hierarchy().fieldError(CellId(c), 0), points.hierarchy().fieldError(CellId(c), 0));
  }
  double beyond = 0.0;
  for (Index c = 0; c < certified.cellCount(); ++c)
  {
    const HierarchyCell& cell = certified.hierarchy().cell(CellId(c));
    const bool isLeaf = !cell.firstChild.valid();
    const auto error = static_cast<double>(certified.hierarchy().fieldError(CellId(c), 0));
    beyond = isLeaf && cell.level < 12 ? std::max(beyond, error) : beyond;
  }
  EXPECT_LE(beyond, 0.35);
}

TEST(CertifiedFields, FieldsThatAreLinearInEachMaterialHaveNoErrorInTheBaseMesh)
{
  const auto linear = [](std::size_t m, const Vector& p) {
    return m == 0 ? 5.0 + p.x() - 2.0 * p.y() + 0.5 * p.z() : -p.x() + 3.0 * p.z();
  };
  const SphereCase sphere = sphereCase(8, 2, linear);
  const CertifiedCells cells(sphere.native, sphere.interfaces, { infinity, { infinity } }, 0);
  ASSERT_EQ(6, cells.cellCount());
  for (Index c = 0; c < 6; ++c)
  {
    EXPECT_LE(cells.hierarchy().fieldError(CellId(c), 0), 2e-6f);
  }
}

TEST(CertifiedFields, QuadraticFieldsConvergeWithSecondOrderInMixedCells)
{
  const auto quadratic = [](std::size_t m, const Vector& p) {
    return m == 0 ? p.squaredNorm() : 3.0 - p.x() * p.y() + p.z() * p.z();
  };
  const SphereCase sphere = sphereCase(24, 4, quadratic);
  // Cubes of 1/4, 1/8 and 1/16: half of the native cells' edges is 1/48.
  std::array<double, 3> errors = { 0.0, 0.0, 0.0 };
  const CertifiedCells cells(sphere.native, sphere.interfaces, { 1e-9, { infinity } }, 12);
  for (Index c = 0; c < cells.cellCount(); ++c)
  {
    const int level = cells.hierarchy().cell(CellId(c)).level;
    if (level > 3 && level % 3 == 0 && cells.hierarchy().materialsOf(CellId(c)).size() > 1)
    {
      double& error = errors[static_cast<std::size_t>(level / 3 - 2)];
      error = std::max(error, static_cast<double>(cells.hierarchy().fieldError(CellId(c), 0)));
    }
  }
  EXPECT_GE(std::log2(errors[0] / errors[1]), 1.6);
  EXPECT_GE(std::log2(errors[1] / errors[2]), 1.8);
}
}
}
