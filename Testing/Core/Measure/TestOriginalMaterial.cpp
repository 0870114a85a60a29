#include "Geometry/TetrahedronLocator.h"
#include "Measure/OriginalMaterial.h"
#include "Measuring.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

using namespace strata;
using namespace strata::test;

namespace
{
Vector randomPoint(std::mt19937_64& random, double size)
{
  std::uniform_real_distribution<double> range(-size, size);
  return { range(random), range(random), range(random) };
}

/// The surface of a positively oriented tetrahedron; normals point outward.
Triangles tetrahedronSurface(const std::array<Vector, 4>& x)
{
  return { { x[0], x[2], x[1] }, { x[0], x[1], x[3] }, { x[1], x[2], x[3] }, { x[0], x[3], x[2] } };
}
}

TEST(OriginalMaterial, IsInsideATetrahedronHoweverSharpItsEdgesAndCorners)
{
  int inside = 0;
  for (unsigned seed = 1; seed <= 200; ++seed)
  {
    std::mt19937_64 random(seed);
    // Flattened along an axis: needles and slivers with edges of a few degrees.
    const Vector stretch = seed % 3 == 0 ? Vector(1, 1, 1) : (seed % 3 == 1 ? Vector(1, 1, 0.1) : Vector(1, 0.1, 0.1));
    std::array<Vector, 4> corners;
    for (Vector& corner : corners)
    {
      corner = randomPoint(random, 1.0).cwiseProduct(stretch);
    }
    if ((corners[1] - corners[0]).dot((corners[2] - corners[0]).cross(corners[3] - corners[0])) < 0.0)
    {
      std::swap(corners[0], corners[1]);
    }
    Interfaces interfaces;
    addSurface(interfaces, B, A, tetrahedronSurface(corners));
    const OriginalMaterial original(interfaces, unitBox(), C);
    const std::array<std::int64_t, 4> cell = { 0, 1, 2, 3 };
    const TetrahedronLocator locator(corners[0].data(), cell.data(), 1);
    TetrahedronLocator::Weights weights{};
    for (int i = 0; i < 500; ++i)
    {
      const Vector p = 1.5 * randomPoint(random, 1.0).cwiseProduct(stretch);
      const bool isInside = locator.holds(0, p, weights);
      EXPECT_EQ(original.at(p).material, isInside ? A : B) << "seed " << seed << ", point " << p.transpose();
      inside += isInside ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 300);
}

TEST(OriginalMaterial, OfConesRoundACornerIsTheConeThatHoldsThePoint)
{
  // The faces between each edge and the center of a tetrahedron divide it into four cones, of one material each.
  const std::array<Vector, 4> corners = { Vector(1, 1, 1), Vector(1, -1, -1), Vector(-1, 1, -1), Vector(-1, -1, 1) };
  const std::array<std::array<int, 3>, 4> opposite = { { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } } };
  Interfaces interfaces;
  interfaces.points = { corners[0], corners[1], corners[2], corners[3], Vector(0.2, -0.3, 0.1) };
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      // The triangle from the center to edge ij separates the cones over the two faces that have that edge.
      std::array<int, 2> others{};
      int count = 0;
      for (int k = 0; k < 4; ++k)
      {
        if (k != i && k != j)
        {
          others[static_cast<std::size_t>(count++)] = k;
        }
      }
      // Cone k lies over the face opposite to corner k. The cone over the face without `others[0]` has others[1].
      const Vector normal = (corners[i] - interfaces.points[4]).cross(corners[j] - interfaces.points[4]);
      const bool towardsSecond = normal.dot(corners[others[1]] - interfaces.points[4]) > 0.0;
      const MaterialId positive(towardsSecond ? others[0] : others[1]);
      const MaterialId negative(towardsSecond ? others[1] : others[0]);
      interfaces.surfaces.push_back({ positive, negative, { { { 4, i, j } } } });
    }
  }
  const OriginalMaterial original(interfaces, unitBox(), MaterialId(7));
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i)
  {
    const Vector p = interfaces.points[4] + randomPoint(random, 0.1);
    int holding = -1;
    for (int k = 0; k < 4; ++k)
    {
      const std::array<Vector, 4> cone = { interfaces.points[4], corners[opposite[k][0]], corners[opposite[k][1]],
        corners[opposite[k][2]] };
      const std::array<std::int64_t, 4> cell = { 0, 1, 2, 3 };
      const TetrahedronLocator locator(cone[0].data(), cell.data(), 1);
      TetrahedronLocator::Weights weights{};
      holding = locator.holds(0, p, weights) ? k : holding;
    }
    EXPECT_EQ(original.at(p).material.value, holding) << p.transpose();
  }
}

TEST(OriginalMaterial, WithoutInterfacesIsTheOneGiven)
{
  const Interfaces none;
  EXPECT_EQ(OriginalMaterial(none, unitBox(), C).at({ 1, 2, 3 }).material, C);
}

TEST(OriginalMaterial, IsNearAGapWhereTheClosestPointIsOnARimWithinTheBox)
{
  // The lower half of the plane x = 0.43: it ends at walls of the box but for the edge y = 0.5.
  Interfaces interfaces;
  addSurface(interfaces, A, B, parallelogram({ 0.43, 0, 0 }, 0.5 * Vector::UnitY(), Vector::UnitZ(), 3));
  const OriginalMaterial original(interfaces, unitBox(), C);
  EXPECT_TRUE(original.hasGaps());
  for (const double x : { 0.2, 0.42, 0.6 })
  {
    for (const double z : { 0.01, 0.5, 0.99 })
    {
      EXPECT_FALSE(original.at({ x, 0.01, z }).nearGap);
      EXPECT_FALSE(original.at({ x, 0.49, z }).nearGap);
      EXPECT_TRUE(original.at({ x, 0.51, z }).nearGap);
      EXPECT_TRUE(original.at({ x, 0.99, z }).nearGap);
    }
  }
  Interfaces whole;
  addSurface(whole, A, B, planeAcrossX(0.43, 3));
  EXPECT_FALSE(OriginalMaterial(whole, unitBox(), C).hasGaps());
}
