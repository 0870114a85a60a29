#include "Support/RandomRegions.h"

#include "Pieces/Pieces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>
#include <set>

using namespace strata;
using namespace strata::test;

namespace
{
Vector pointOf(const RepresentedSurfaces& surfaces, Index corner)
{
  const Index point = surfaces.triangles[corner];
  return { surfaces.points[3 * point], surfaces.points[3 * point + 1], surfaces.points[3 * point + 2] };
}

RepresentedSurfaces surfacesOf(const Mesh& mesh)
{
  Progress progress;
  return representedInterfaces(view(mesh), progress);
}

Vector areaOf(const RepresentedSurfaces& surfaces, Index triangle)
{
  const Vector origin = pointOf(surfaces, 3 * triangle);
  return 0.5 * (pointOf(surfaces, 3 * triangle + 1) - origin).cross(pointOf(surfaces, 3 * triangle + 2) - origin);
}

bool onOneSideOfTheCube(const Vector& a, const Vector& b)
{
  return ((a.array() == 0.0) && (b.array() == 0.0)).any() || ((a.array() == 1.0) && (b.array() == 1.0)).any();
}
}

TEST(RepresentedInterfaces, BoundEachMaterialTogetherWithTheBox)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const int materials = 2 + seed % 5;
    const Mesh mesh =
      randomRegions(2 + seed % 2, materials, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    const RepresentedSurfaces surfaces = surfacesOf(mesh);
    for (int m = 0; m < materials; ++m)
    {
      std::map<std::pair<std::int64_t, std::int64_t>, int> balance;
      for (Index corner = 0; corner < surfaces.triangles.size(); ++corner)
      {
        const Index triangle = corner / 3;
        if (surfaces.positive[triangle] != m && surfaces.negative[triangle] != m)
        {
          continue;
        }
        const std::int64_t a = surfaces.triangles[corner];
        const std::int64_t b = surfaces.triangles[3 * triangle + (corner + 1) % 3];
        const int sign = (surfaces.positive[triangle] == m ? 1 : -1) * (a < b ? 1 : -1);
        balance[std::minmax(a, b)] += sign;
      }
      for (const auto& edge : balance)
      {
        const auto at = [&](Index point) {
          return Vector(surfaces.points[3 * point], surfaces.points[3 * point + 1], surfaces.points[3 * point + 2]);
        };
        ASSERT_TRUE(edge.second == 0 || onOneSideOfTheCube(at(edge.first.first), at(edge.first.second)))
          << "seed " << seed << " material " << m;
      }
    }
  }
}

TEST(RepresentedInterfaces, OfAPlaneArePiecesOfItTurnedToThePositiveSide)
{
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  Mesh mesh = kuhnMesh(box, 4, { { "a", true }, { "b", true } }, { { "f", 1 } });
  // Distances are exact in floats: the normal has components 1/4 and so have the coordinates.
  setTwoMaterials(mesh, MaterialId(0), MaterialId(1), [](const Vector& p) { return 0.375 - p[0]; });
  setValues(mesh, FieldId(0), MaterialId(0), [](const Vector& p, int) { return p[1]; });
  setValues(mesh, FieldId(0), MaterialId(1), [](const Vector& p, int) { return 5.0 + p[2]; });
  const RepresentedSurfaces surfaces = surfacesOf(mesh);
  Vector area = Vector::Zero();
  for (Index triangle = 0; triangle < surfaces.positive.size(); ++triangle)
  {
    EXPECT_EQ(surfaces.positive[triangle], 0);
    EXPECT_EQ(surfaces.negative[triangle], 1);
    area += areaOf(surfaces, triangle);
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
    {
      const Vector p = pointOf(surfaces, corner);
      EXPECT_DOUBLE_EQ(p[0], 0.375);
      EXPECT_NEAR(surfaces.positiveValues[0][corner], p[1], 1e-6);
      EXPECT_NEAR(surfaces.negativeValues[0][corner], 5.0 + p[2], 1e-6);
    }
  }
  EXPECT_LT((area - Vector(-1, 0, 0)).norm(), 1e-13);
}

TEST(RepresentedInterfaces, AlongALayerOfFacesAppearOnce)
{
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  Mesh mesh = kuhnMesh(box, 4, { { "a", true }, { "b", true } }, {});
  for (double at : { 0.25, 0.5 })
  {
    for (double sign : { 1.0, -1.0 })
    {
      setTwoMaterials(mesh, MaterialId(0), MaterialId(1), [&](const Vector& p) { return sign * (at - p[1]); });
      const RepresentedSurfaces surfaces = surfacesOf(mesh);
      Vector area = Vector::Zero();
      double size = 0.0;
      for (Index triangle = 0; triangle < surfaces.positive.size(); ++triangle)
      {
        area += areaOf(surfaces, triangle);
        size += areaOf(surfaces, triangle).norm();
      }
      EXPECT_LT((area - Vector(0, -sign, 0)).norm(), 1e-14);
      EXPECT_DOUBLE_EQ(size, 1.0);
      EXPECT_EQ(surfaces.positive.size(), 32);
      EXPECT_EQ(surfaces.points.size(), 3 * 25);
    }
  }
}

TEST(RepresentedInterfaces, ShareEveryPoint)
{
  const Mesh mesh = randomRegions(3, 4, RandomDistances::Reals, 2);
  const RepresentedSurfaces surfaces = surfacesOf(mesh);
  std::set<std::array<double, 3>> places;
  for (Index point = 0; point < surfaces.points.size() / 3; ++point)
  {
    places.insert({ surfaces.points[3 * point], surfaces.points[3 * point + 1], surfaces.points[3 * point + 2] });
  }
  EXPECT_EQ(static_cast<Index>(places.size()), surfaces.points.size() / 3);
}

TEST(RepresentedInterfaces, HaveNoValueOnASideWithoutFields)
{
  const Mesh mesh = randomRegions(2, 2, RandomDistances::Reals, 2);
  const RepresentedSurfaces surfaces = surfacesOf(mesh);
  ASSERT_GT(surfaces.positive.size(), 0);
  for (Index corner = 0; corner < surfaces.triangles.size(); ++corner)
  {
    EXPECT_FALSE(std::isnan(surfaces.positiveValues[0][corner]));
    EXPECT_TRUE(std::isnan(surfaces.negativeValues[0][corner]));
  }
}

TEST(RepresentedInterfaces, AreTheSameForAnyNumberOfThreads)
{
  const Mesh mesh = randomRegions(8, 4, RandomDistances::Ties, 3);
  const RepresentedSurfaces two = surfacesOf(mesh);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const RepresentedSurfaces single = surfacesOf(mesh);
  EXPECT_EQ(copyOf(two.points), copyOf(single.points));
  EXPECT_EQ(copyOf(two.triangles), copyOf(single.triangles));
  EXPECT_EQ(copyOf(two.cell), copyOf(single.cell));
}
