#include "Core/Slice/SliceSupport.h"

#include "Model/Errors.h"
#include "Slice/SliceIndex.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <map>
#include <set>

using namespace strata;
using namespace strata::test;

TEST(Slice, AreasOfTheMaterialsSumToTheSectionOfTheBox)
{
  std::mt19937 random(1);
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const int n = 2 + seed % 3;
    const int materials = 1 + seed % 5;
    const Mesh mesh = randomRegions(n, materials, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    for (int i = 0; i < 6; ++i)
    {
      const SlicePlane plane = randomPlane(i % 2, n, random);
      const MaterialPolygons polygons = sliceAll(mesh, plane);
      const double expected = sectionOfUnitCube(plane);
      const double area = total(areasByMaterial(polygons, materials));
      // A plane in a face of the cube is all or nothing by the sign rule; both are tested below.
      const bool inFace = (plane.normal.array() != 0.0).count() == 1;
      ASSERT_NEAR(area, inFace ? 1.0 : expected, 1e-12) << "seed " << seed << " plane " << i;
    }
  }
}

TEST(Slice, APlaneAlongAnyLayerOfVerticesShowsItOnce)
{
  const int n = 4;
  const Mesh mesh = randomRegions(n, 3, RandomDistances::Reals, 5);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int layer = 0; layer <= n; ++layer)
    {
      for (double sign : { 1.0, -1.0 })
      {
        const SlicePlane plane = planeOf(Vector::Constant(layer / static_cast<double>(n)), sign * Vector::Unit(axis));
        const MaterialPolygons polygons = sliceAll(mesh, plane);
        EXPECT_NEAR(total(areasByMaterial(polygons, 3)), 1.0, 1e-13) << "axis " << axis << " layer " << layer;
        for (Index p = 0; p < polygonCount(polygons); ++p)
        {
          EXPECT_GE(areaOf(polygons, p).dot(plane.normal), 0.0);
        }
      }
    }
  }
}

TEST(Slice, PolygonsLieInThePlaneTurnedAlongItsNormalAndConvex)
{
  std::mt19937 random(2);
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    const Mesh mesh = randomRegions(3, 4, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    const SlicePlane plane = randomPlane(seed / 2 % 2, 3, random);
    const MaterialPolygons polygons = sliceAll(mesh, plane);
    const Vector normal = plane.normal.normalized();
    for (Index p = 0; p < polygonCount(polygons); ++p)
    {
      const Index begin = polygons.offsets[p];
      const Index size = polygons.offsets[p + 1] - begin;
      ASSERT_GE(size, 3);
      std::set<std::int64_t> corners;
      for (Index i = 0; i < size; ++i)
      {
        const Vector a = pointOf(polygons, begin + i);
        const Vector b = pointOf(polygons, begin + (i + 1) % size);
        const Vector c = pointOf(polygons, begin + (i + 2) % size);
        ASSERT_NEAR(normal.dot(a - plane.origin), 0.0, 1e-14);
        ASSERT_GE((b - a).cross(c - b).dot(normal), -1e-14);
        corners.insert(polygons.corners[begin + i]);
      }
      ASSERT_EQ(static_cast<Index>(corners.size()), size);
    }
  }
}

TEST(Slice, PolygonsLeaveNoGap)
{
  std::mt19937 random(3);
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    // Vertices of four layers lie exactly in planes, those of three layers but for rounding.
    const int n = 3 + seed / 4 % 2;
    const Mesh mesh = randomRegions(n, 1 + seed % 4, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    const MaterialPolygons polygons = sliceAll(mesh, randomPlane(seed / 2 % 2, n, random));
    for (const auto& edge : edgeBalance(polygons))
    {
      ASSERT_TRUE(edge.second == 0 || onOneSideOfTheCube(edge.first)) << "seed " << seed;
    }
  }
}

TEST(Slice, PointsAreSharedWithinAMaterialAndNeverAcross)
{
  const Mesh mesh = randomRegions(4, 3, RandomDistances::Reals, 9);
  const MaterialPolygons polygons = sliceAll(mesh, planeOf(Vector(0.4, 0.5, 0.6), Vector(1, 2, 3)));
  std::map<std::int64_t, std::int32_t> materialOfPoint;
  std::set<std::array<double, 4>> different;
  for (Index p = 0; p < polygonCount(polygons); ++p)
  {
    for (Index i = polygons.offsets[p]; i < polygons.offsets[p + 1]; ++i)
    {
      const auto known = materialOfPoint.emplace(polygons.corners[i], polygons.material[p]).first;
      EXPECT_EQ(known->second, polygons.material[p]);
      const Vector at = pointOf(polygons, i);
      different.insert({ at[0], at[1], at[2], static_cast<double>(polygons.material[p]) });
    }
  }
  EXPECT_EQ(static_cast<Index>(materialOfPoint.size()), polygons.points.size() / 3);
  EXPECT_EQ(different.size(), materialOfPoint.size());
}

TEST(Slice, ASphereShowsADiscOfItsMaterial)
{
  const int n = 24;
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  Mesh mesh = kuhnMesh(box, n, { { "ball", true }, { "empty", false } }, { { "scalar", 1 } });
  const Vector center(0.5, 0.5, 0.5);
  setTwoMaterials(mesh, MaterialId(0), MaterialId(1), [&](const Vector& p) { return 0.3 - (p - center).norm(); });
  setValues(mesh, FieldId(0), MaterialId(0), [](const Vector& p, int) { return 1.0 + p[0]; });
  const SlicePlane plane = planeOf(center + Vector(0, 0, 0.1), Vector::UnitZ());
  const MaterialPolygons polygons = sliceAll(mesh, plane);
  const std::vector<double> areas = areasByMaterial(polygons, 2);
  const double disc = 3.14159265358979323846 * (0.3 * 0.3 - 0.1 * 0.1);
  // The linear interpolation of the distance errs by h^2 / (8 r) or less along each of the directions.
  EXPECT_NEAR(areas[0], disc, 2.0 * 3.14159 * 0.3 * 3.0 / (8.0 * 0.28 * n * n));
  EXPECT_NEAR(areas[0] + areas[1], 1.0, 1e-12);
}

TEST(Slice, FieldsAreThoseOfThePolygonsMaterial)
{
  const int materials = 4;
  const Mesh mesh = randomRegions(3, materials, RandomDistances::Reals, 4);
  const MaterialPolygons polygons = sliceAll(mesh, planeOf(Vector(0.4, 0.5, 0.6), Vector(-1, 2, 1)));
  ASSERT_EQ(polygons.values.size(), 2u);
  for (Index p = 0; p < polygonCount(polygons); ++p)
  {
    const int m = polygons.material[p];
    for (Index i = polygons.offsets[p]; i < polygons.offsets[p + 1]; ++i)
    {
      const Vector at = pointOf(polygons, i);
      const Index point = polygons.corners[i];
      if (m + 1 == materials)
      {
        EXPECT_TRUE(std::isnan(polygons.values[0][point]));
        continue;
      }
      EXPECT_NEAR(polygons.values[0][point], 10.0 * m + at[0] - 2.0 * at[1] + 3.0 * at[2], 1e-5);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(polygons.values[1][3 * point + c], at[c] - m, 1e-6);
      }
    }
  }
}

TEST(Slice, ChosenMaterialsAreThoseOfTheWholeSlice)
{
  const Mesh mesh = randomRegions(3, 4, RandomDistances::Reals, 6);
  const SlicePlane plane = planeOf(Vector(0.4, 0.5, 0.6), Vector(-1, 2, 1));
  MaterialSet some = MaterialSet::of(MaterialId(1));
  some.insert(MaterialId(3));
  Progress progress;
  const MaterialPolygons polygons = slice(view(mesh), plane, some, nullptr, progress);
  const std::vector<double> all = areasByMaterial(sliceAll(mesh, plane), 4);
  const std::vector<double> chosen = areasByMaterial(polygons, 4);
  EXPECT_EQ(chosen, (std::vector<double>{ 0.0, all[1], 0.0, all[3] }));
}

TEST(Slice, TurningTheNormalOnlyTurnsThePolygons)
{
  const Mesh mesh = randomRegions(3, 4, RandomDistances::Reals, 6);
  const SlicePlane plane = planeOf(Vector(0.4, 0.5, 0.6), Vector(-1, 2, 1));
  SlicePlane turned = plane;
  turned.normal = -plane.normal;
  const MaterialPolygons polygons = sliceAll(mesh, plane);
  const MaterialPolygons back = sliceAll(mesh, turned);
  ASSERT_EQ(copyOf(polygons.material), copyOf(back.material));
  ASSERT_EQ(copyOf(polygons.tetrahedron), copyOf(back.tetrahedron));
  for (Index p = 0; p < polygonCount(polygons); ++p)
  {
    EXPECT_LT((areaOf(polygons, p) + areaOf(back, p)).norm(), 1e-15);
  }
}

TEST(Slice, NeitherAnIndexNorTheNumberOfThreadsChangesAByte)
{
  std::mt19937 random(13);
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const Mesh mesh = randomRegions(8, 4, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    const SlicePlane plane = randomPlane(seed / 2 % 2, 8, random);
    Progress progress;
    const SliceIndex index(view(mesh), progress);
    const MaterialPolygons two = sliceAll(mesh, plane);
    const MaterialPolygons indexed = slice(view(mesh), plane, allMaterials(mesh), &index, progress);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const MaterialPolygons single = sliceAll(mesh, plane);
    expectSameBytes(two, single);
    expectSameBytes(two, indexed);
  }
}

TEST(Slice, AnOffsetMovesThePlaneAlongItsNormal)
{
  const Mesh mesh = randomRegions(3, 2, RandomDistances::Reals, 6);
  SlicePlane plane = planeOf(Vector::Zero(), Vector::UnitX());
  plane.offset = 0.25;
  const MaterialPolygons polygons = sliceAll(mesh, plane);
  ASSERT_GT(polygons.points.size(), 0);
  for (Index point = 0; point < polygons.points.size() / 3; ++point)
  {
    EXPECT_DOUBLE_EQ(polygons.points[3 * point], 0.25);
  }
}

TEST(Slice, APlaneBesideTheBoxCutsNothing)
{
  const Mesh mesh = randomRegions(2, 2, RandomDistances::Reals, 6);
  for (double x : { -0.5, 1.5 })
  {
    const MaterialPolygons polygons = sliceAll(mesh, planeOf(Vector(x, 0, 0), Vector::UnitX()));
    EXPECT_EQ(polygonCount(polygons), 0);
    EXPECT_EQ(polygons.points.size(), 0);
    ASSERT_EQ(polygons.offsets.size(), 1);
    EXPECT_EQ(polygons.offsets[0], 0);
  }
}

TEST(Slice, BadInputIsNamed)
{
  Mesh mesh = randomRegions(1, 2, RandomDistances::Reals, 6);
  EXPECT_THROW(sliceAll(mesh, planeOf(Vector::Zero(), Vector::Zero())), InvalidInput);
  EXPECT_THROW(sliceAll(mesh, planeOf(Vector::Zero(), Vector::Constant(std::nan("")))), InvalidInput);
  const Mesh other = randomRegions(2, 2, RandomDistances::Reals, 6);
  Progress progress;
  const SliceIndex index(view(other), progress);
  const SlicePlane plane = planeOf(Vector::Constant(0.5), Vector::UnitX());
  EXPECT_THROW(slice(view(mesh), plane, allMaterials(mesh), &index, progress), InvalidInput);
  mesh.distances[0][0] = std::nanf("");
  mesh.distances[1][0] = std::nanf("");
  EXPECT_THROW(sliceAll(mesh, plane), InvalidInput);
  mesh.distances[1][0] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(sliceAll(mesh, plane), InvalidInput);
}

TEST(Slice, StopsWhenCancelled)
{
  const Mesh mesh = randomRegions(2, 2, RandomDistances::Reals, 6);
  Progress progress([](const std::string&, double) { return false; });
  EXPECT_THROW(
    {
      progress.update(0.5);
      slice(view(mesh), planeOf(Vector::Constant(0.5), Vector::UnitX()), allMaterials(mesh), nullptr, progress);
    },
    Cancelled);
}
