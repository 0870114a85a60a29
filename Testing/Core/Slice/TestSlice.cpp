#include "Support/RandomRegions.h"

#include "Model/Errors.h"
#include "Slice/Slice.h"
#include "Slice/SliceIndex.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>

using namespace strata;
using namespace strata::test;

namespace
{
Vector pointOf(const SlicePolygons& polygons, Index corner)
{
  const Index point = polygons.corners[corner];
  return { polygons.points[3 * point], polygons.points[3 * point + 1], polygons.points[3 * point + 2] };
}

Index polygonCount(const SlicePolygons& polygons)
{
  return polygons.material.size();
}

Vector areaOf(const SlicePolygons& polygons, Index polygon)
{
  Vector sum = Vector::Zero();
  const Vector origin = pointOf(polygons, polygons.offsets[polygon]);
  for (Index i = polygons.offsets[polygon] + 1; i + 1 < polygons.offsets[polygon + 1]; ++i)
  {
    sum += 0.5 * (pointOf(polygons, i) - origin).cross(pointOf(polygons, i + 1) - origin);
  }
  return sum;
}

std::vector<double> areasByMaterial(const SlicePolygons& polygons, int materials)
{
  std::vector<double> result(materials, 0.0);
  for (Index p = 0; p < polygonCount(polygons); ++p)
  {
    result[polygons.material[p]] += areaOf(polygons, p).norm();
  }
  return result;
}

double total(const std::vector<double>& values)
{
  double sum = 0.0;
  for (double value : values)
  {
    sum += value;
  }
  return sum;
}

/// Area of the section of the unit cube with a plane: the integral of the gradient form, by clipping the cube's six
/// faces' edges. Points where the plane crosses the cube's edges, ordered by angle.
double sectionOfUnitCube(const SlicePlane& plane)
{
  const Vector normal = plane.normal.normalized();
  const auto value = [&](const Vector& p) { return plane.normal.dot(p - plane.origin) - plane.offset; };
  std::vector<Vector> points;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      Vector a = Vector::Zero();
      a[(axis + 1) % 3] = corner & 1;
      a[(axis + 2) % 3] = corner >> 1;
      const Vector b = a + Vector::Unit(axis);
      if ((value(a) >= 0.0) != (value(b) >= 0.0))
      {
        points.push_back(a + (b - a) * (value(a) / (value(a) - value(b))));
      }
    }
  }
  if (points.size() < 3)
  {
    return 0.0;
  }
  Vector center = Vector::Zero();
  for (const Vector& p : points)
  {
    center += p / static_cast<double>(points.size());
  }
  const Vector u = normal.unitOrthogonal();
  const Vector v = normal.cross(u);
  const auto angle = [&](const Vector& p) { return std::atan2((p - center).dot(v), (p - center).dot(u)); };
  std::sort(points.begin(), points.end(), [&](const Vector& a, const Vector& b) { return angle(a) < angle(b); });
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    area += 0.5 * (points[i] - center).cross(points[(i + 1) % points.size()] - center).dot(normal);
  }
  return area;
}

SlicePlane planeOf(const Vector& origin, const Vector& normal)
{
  SlicePlane plane;
  plane.origin = origin;
  plane.normal = normal;
  return plane;
}

SlicePolygons sliceAll(const Mesh& mesh, const SlicePlane& plane)
{
  Progress progress;
  return slice(view(mesh), plane, allMaterials(mesh), nullptr, progress);
}

/// Random planes: in general position, through vertices, along faces.
SlicePlane randomPlane(int kind, int n, std::mt19937& random)
{
  std::uniform_real_distribution<double> real(0.0, 1.0);
  std::uniform_int_distribution<int> lattice(0, n);
  std::uniform_int_distribution<int> direction(-2, 2);
  SlicePlane plane;
  if (kind == 0)
  {
    plane.origin = Vector(real(random), real(random), real(random));
    plane.normal = Vector(real(random) - 0.5, real(random) - 0.5, real(random) - 0.5);
    return plane;
  }
  plane.origin = Vector(lattice(random), lattice(random), lattice(random)) / n;
  do
  {
    plane.normal = Vector(direction(random), direction(random), direction(random));
  } while (plane.normal.isZero(0.0));
  return plane;
}

/// Net uses of undirected edges by position: 0 inside a surface without gap and overlap.
std::map<std::array<double, 6>, int> edgeBalance(const SlicePolygons& polygons)
{
  std::map<std::array<double, 6>, int> balance;
  for (Index p = 0; p < polygonCount(polygons); ++p)
  {
    for (Index i = polygons.offsets[p]; i < polygons.offsets[p + 1]; ++i)
    {
      const Index next = i + 1 < polygons.offsets[p + 1] ? i + 1 : polygons.offsets[p];
      const Vector a = pointOf(polygons, i);
      const Vector b = pointOf(polygons, next);
      if (a == b)
      {
        continue; // different points that round to the same place, where the plane all but meets a vertex
      }
      const bool ascending = std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
      const Vector& first = ascending ? a : b;
      const Vector& second = ascending ? b : a;
      balance[{ first[0], first[1], first[2], second[0], second[1], second[2] }] += ascending ? 1 : -1;
    }
  }
  return balance;
}

bool onOneSideOfTheCube(const std::array<double, 6>& edge)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double lower = std::min(edge[axis], edge[axis + 3]);
    const double upper = std::max(edge[axis], edge[axis + 3]);
    if (upper < 1e-12 || lower > 1.0 - 1e-12)
    {
      return true;
    }
  }
  return false;
}

template<typename T>
bool sameBytes(const Buffer<T>& a, const Buffer<T>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), sizeof(T) * static_cast<std::size_t>(a.size())) == 0;
}

void expectSameBytes(const SlicePolygons& a, const SlicePolygons& b)
{
  EXPECT_TRUE(sameBytes(a.points, b.points));
  EXPECT_TRUE(sameBytes(a.offsets, b.offsets));
  EXPECT_TRUE(sameBytes(a.corners, b.corners));
  EXPECT_TRUE(sameBytes(a.material, b.material));
  EXPECT_TRUE(sameBytes(a.tetrahedron, b.tetrahedron));
  ASSERT_EQ(a.values.size(), b.values.size());
  for (std::size_t field = 0; field < a.values.size(); ++field)
  {
    EXPECT_TRUE(sameBytes(a.values[field], b.values[field]));
  }
}
}

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
      const SlicePolygons polygons = sliceAll(mesh, plane);
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
        const SlicePolygons polygons = sliceAll(mesh, plane);
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
    const SlicePolygons polygons = sliceAll(mesh, plane);
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
    const SlicePolygons polygons = sliceAll(mesh, randomPlane(seed / 2 % 2, n, random));
    for (const auto& edge : edgeBalance(polygons))
    {
      ASSERT_TRUE(edge.second == 0 || onOneSideOfTheCube(edge.first)) << "seed " << seed;
    }
  }
}

TEST(Slice, PointsAreSharedWithinAMaterialAndNeverAcross)
{
  const Mesh mesh = randomRegions(4, 3, RandomDistances::Reals, 9);
  const SlicePolygons polygons = sliceAll(mesh, planeOf(Vector(0.4, 0.5, 0.6), Vector(1, 2, 3)));
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
  const SlicePolygons polygons = sliceAll(mesh, plane);
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
  const SlicePolygons polygons = sliceAll(mesh, planeOf(Vector(0.4, 0.5, 0.6), Vector(-1, 2, 1)));
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
  const SlicePolygons polygons = slice(view(mesh), plane, some, nullptr, progress);
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
  const SlicePolygons polygons = sliceAll(mesh, plane);
  const SlicePolygons back = sliceAll(mesh, turned);
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
    const SlicePolygons two = sliceAll(mesh, plane);
    const SlicePolygons indexed = slice(view(mesh), plane, allMaterials(mesh), &index, progress);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const SlicePolygons single = sliceAll(mesh, plane);
    expectSameBytes(two, single);
    expectSameBytes(two, indexed);
  }
}

TEST(Slice, AnOffsetMovesThePlaneAlongItsNormal)
{
  const Mesh mesh = randomRegions(3, 2, RandomDistances::Reals, 6);
  SlicePlane plane = planeOf(Vector::Zero(), Vector::UnitX());
  plane.offset = 0.25;
  const SlicePolygons polygons = sliceAll(mesh, plane);
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
    const SlicePolygons polygons = sliceAll(mesh, planeOf(Vector(x, 0, 0), Vector::UnitX()));
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
