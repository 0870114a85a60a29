#include "Support/RandomRegions.h"

#include "Sample/Sample.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

using namespace strata;
using namespace strata::test;

namespace
{
Samples sampleAt(const Mesh& mesh, const std::vector<Vector>& points)
{
  std::vector<double> flat;
  for (const Vector& p : points)
  {
    flat.insert(flat.end(), p.data(), p.data() + 3);
  }
  Progress progress;
  return sample(view(mesh), flat.data(), static_cast<Index>(points.size()), progress);
}

std::vector<Vector> randomPoints(int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> real(0.0, 1.0);
  std::vector<Vector> result;
  for (int i = 0; i < count; ++i)
  {
    result.emplace_back(real(random), real(random), real(random));
  }
  return result;
}

/// The cell of a Kuhn mesh of n^3 cubes that holds a point in general position: in its cube, the corner path goes
/// along the axes by falling fractions.
Index cellAt(const Vector& p, int n)
{
  std::array<int, 3> cube;
  std::array<double, 3> part;
  for (int axis = 0; axis < 3; ++axis)
  {
    cube[axis] = static_cast<int>(p[axis] * n);
    part[axis] = p[axis] * n - cube[axis];
  }
  std::array<int, 3> path{ 0, 1, 2 };
  std::sort(path.begin(), path.end(), [&](int a, int b) { return part[a] > part[b]; });
  const std::array<std::array<int, 3>, 6> paths = { { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 2, 1, 0 } } };
  const Index position = std::find(paths.begin(), paths.end(), path) - paths.begin();
  return 6 * (cube[0] + Index{ n } * (cube[1] + Index{ n } * cube[2])) + position;
}
}

TEST(Sample, FindsTheCellThatHoldsAPoint)
{
  const int n = 5;
  const Mesh mesh = randomRegions(n, 3, RandomDistances::Reals, 1);
  const std::vector<Vector> points = randomPoints(5000, 1);
  const Samples samples = sampleAt(mesh, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(samples.cell[static_cast<Index>(i)], cellAt(points[i], n));
    ASSERT_EQ(samples.outside[static_cast<Index>(i)], 0);
  }
}

TEST(Sample, OnSharedFacesTakesTheLowestCellAndLosesNoPointOfTheBox)
{
  const int n = 3; // coordinates that aren't exact
  const Mesh mesh = randomRegions(n, 3, RandomDistances::Reals, 1);
  std::vector<Vector> points;
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    points.push_back(vertexPosition(mesh, vertex));
  }
  for (Index cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const auto at = [&](int corner) { return vertexPosition(mesh, mesh.tetrahedra[4 * cell + corner]); };
    points.emplace_back(0.3 * at(0) + 0.7 * at(2));
    points.emplace_back((at(0) + at(1) + at(3)) / 3.0);
  }
  const Samples samples = sampleAt(mesh, points);
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    Index lowest = 0;
    while (std::find(&mesh.tetrahedra[4 * lowest], &mesh.tetrahedra[4 * lowest] + 4, vertex) ==
           &mesh.tetrahedra[4 * lowest] + 4)
    {
      ++lowest;
    }
    EXPECT_EQ(samples.cell[vertex], lowest);
  }
  for (Index i = mesh.vertexCount(); i < samples.cell.size(); ++i)
  {
    ASSERT_GE(samples.cell[i], 0);
    ASSERT_LE(samples.cell[i], (i - mesh.vertexCount()) / 2);
  }
}

TEST(Sample, TakesTheMaterialWithTheSmallestDistanceAndTheLowestOfTying)
{
  const Samples tie = sampleAt(
    [] {
      Mesh mesh = randomRegions(1, 3, RandomDistances::Reals, 1);
      setDistances(mesh, MaterialId(0), [](const Vector& p) { return 1.0 + p[0]; });
      setDistances(mesh, MaterialId(1), [](const Vector& p) { return p[0]; });
      setDistances(mesh, MaterialId(2), [](const Vector& p) { return p[0]; });
      return mesh;
    }(),
    randomPoints(100, 3));
  for (Index i = 0; i < 100; ++i)
  {
    EXPECT_EQ(tie.material[i], 1);
  }
  const Mesh mesh = [] {
    Mesh result = randomRegions(2, 2, RandomDistances::Reals, 1);
    setDistances(result, MaterialId(0), [](const Vector& p) { return p[0]; });
    setDistances(result, MaterialId(1), [](const Vector& p) { return 1.0 - p[1]; });
    return result;
  }();
  const std::vector<Vector> points = randomPoints(2000, 4);
  const Samples samples = sampleAt(mesh, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (std::abs(points[i][0] + points[i][1] - 1.0) > 1e-6)
    {
      EXPECT_EQ(samples.material[static_cast<Index>(i)], points[i][0] + points[i][1] < 1.0 ? 0 : 1);
    }
  }
}

TEST(Sample, GivesTheFieldsOfTheMaterialAtThePoint)
{
  const int materials = 4;
  const Mesh mesh = randomRegions(3, materials, RandomDistances::Reals, 2);
  const std::vector<Vector> points = randomPoints(2000, 2);
  const Samples samples = sampleAt(mesh, points);
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i)
  {
    const Vector& p = points[static_cast<std::size_t>(i)];
    const int m = samples.material[i];
    if (m + 1 == materials)
    {
      EXPECT_TRUE(std::isnan(samples.values[0][i]));
      continue;
    }
    EXPECT_NEAR(samples.values[0][i], 10.0 * m + p[0] - 2.0 * p[1] + 3.0 * p[2], 1e-5);
    EXPECT_NEAR(samples.values[1][3 * i + 1], p[1] - m, 1e-6);
  }
}

TEST(Sample, MaterialsThatACellLacksDoNotTakePart)
{
  Mesh mesh = randomRegions(1, 2, RandomDistances::Reals, 1);
  setDistances(mesh, MaterialId(0), [](const Vector&) { return 0.0; });
  setDistances(mesh, MaterialId(1), [](const Vector&) { return 1.0; });
  mesh.distances[0][0] = std::nanf("");
  // All cells of one cube share vertex 0.
  const Samples samples = sampleAt(mesh, { Vector(0.9, 0.8, 0.7) });
  EXPECT_EQ(samples.material[0], 1);
}

TEST(Sample, PointsOutsideHaveNothing)
{
  const Mesh mesh = randomRegions(2, 2, RandomDistances::Reals, 1);
  const Samples samples = sampleAt(mesh, { Vector(1.01, 0.5, 0.5), Vector(0.5, -3.0, 0.5), Vector(0.5, 0.5, 0.5) });
  for (Index i = 0; i < 2; ++i)
  {
    EXPECT_EQ(samples.cell[i], -1);
    EXPECT_EQ(samples.material[i], -1);
    EXPECT_EQ(samples.outside[i], 1);
    EXPECT_TRUE(std::isnan(samples.values[0][i]));
  }
  EXPECT_EQ(samples.outside[2], 0);
}

TEST(Sample, OfNothingIsNothing)
{
  Progress progress;
  EXPECT_EQ(sample(Representation(), nullptr, 0, progress).cell.size(), 0);
  const double point[3] = { 0.0, 0.0, 0.0 };
  EXPECT_EQ(sample(Representation(), point, 1, progress).outside[0], 1);
}

TEST(Sample, IsTheSameForAnyNumberOfThreads)
{
  const Mesh mesh = randomRegions(6, 4, RandomDistances::Ties, 2);
  const std::vector<Vector> points = randomPoints(20000, 2);
  const Samples two = sampleAt(mesh, points);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Samples single = sampleAt(mesh, points);
  EXPECT_EQ(copyOf(two.cell), copyOf(single.cell));
  EXPECT_EQ(copyOf(two.material), copyOf(single.material));
}
