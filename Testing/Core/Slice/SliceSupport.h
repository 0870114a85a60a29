#pragma once

#include "Support/RandomRegions.h"

#include "Slice/Slice.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace strata::test
{
inline Vector pointOf(const MaterialPolygons& polygons, Index corner)
{
  const Index point = polygons.corners[corner];
  return { polygons.points[3 * point], polygons.points[3 * point + 1], polygons.points[3 * point + 2] };
}

inline Index polygonCount(const MaterialPolygons& polygons)
{
  return polygons.material.size();
}

inline Vector areaOf(const MaterialPolygons& polygons, Index polygon)
{
  Vector sum = Vector::Zero();
  const Vector origin = pointOf(polygons, polygons.offsets[polygon]);
  for (Index i = polygons.offsets[polygon] + 1; i + 1 < polygons.offsets[polygon + 1]; ++i)
  {
    sum += 0.5 * (pointOf(polygons, i) - origin).cross(pointOf(polygons, i + 1) - origin);
  }
  return sum;
}

inline std::vector<double> areasByMaterial(const MaterialPolygons& polygons, int materials)
{
  std::vector<double> result(materials, 0.0);
  for (Index p = 0; p < polygonCount(polygons); ++p)
  {
    result[polygons.material[p]] += areaOf(polygons, p).norm();
  }
  return result;
}

inline double total(const std::vector<double>& values)
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
inline double sectionOfUnitCube(const SlicePlane& plane)
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

inline SlicePlane planeOf(const Vector& origin, const Vector& normal)
{
  SlicePlane plane;
  plane.origin = origin;
  plane.normal = normal;
  return plane;
}

inline MaterialPolygons sliceAll(const Mesh& mesh, const SlicePlane& plane)
{
  Progress progress;
  return slice(view(mesh), plane, allMaterials(mesh), nullptr, progress);
}

/// Random planes: in general position, through vertices, along faces.
inline SlicePlane randomPlane(int kind, int n, std::mt19937& random)
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
inline std::map<std::array<double, 6>, int> edgeBalance(const MaterialPolygons& polygons)
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

inline bool onOneSideOfTheCube(const std::array<double, 6>& edge)
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
inline bool sameBytes(const Buffer<T>& a, const Buffer<T>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), sizeof(T) * static_cast<std::size_t>(a.size())) == 0;
}

inline void expectSameBytes(const MaterialPolygons& a, const MaterialPolygons& b)
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
