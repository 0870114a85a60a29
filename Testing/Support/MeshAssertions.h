#pragma once

#include "Model/Representation.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

namespace strata::test
{
inline std::array<Vector, 4> cornersOf(const Mesh& mesh, Index cell)
{
  std::array<Vector, 4> result;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Index v = mesh.tetrahedra[4 * cell + static_cast<Index>(i)];
    result[i] = Vector(mesh.points[3 * v], mesh.points[3 * v + 1], mesh.points[3 * v + 2]);
  }
  return result;
}

inline double volumeOf(const std::array<Vector, 4>& c)
{
  return (c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0]) / 6.0;
}

/// Every face belongs to two cells, or to one and lies in a wall of the box; and the cells fill the box.
inline void expectConforming(const Mesh& mesh, const Box& box)
{
  std::map<std::array<std::int64_t, 3>, int> faces;
  double volume = 0.0;
  for (Index c = 0; c < mesh.cellCount(); ++c)
  {
    const double v = volumeOf(cornersOf(mesh, c));
    ASSERT_GT(v, 0.0) << "cell " << c;
    volume += v;
    const std::int64_t* t = mesh.tetrahedra.data() + 4 * c;
    for (int skip = 0; skip < 4; ++skip)
    {
      std::array<std::int64_t, 3> face = { t[(skip + 1) % 4], t[(skip + 2) % 4], t[(skip + 3) % 4] };
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  EXPECT_NEAR(volume, box.volume(), 1e-12 * box.volume() * static_cast<double>(mesh.cellCount()));
  for (const auto& [face, count] : faces)
  {
    ASSERT_LE(count, 2);
    if (count == 2)
    {
      continue;
    }
    bool inWall = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto at = [&, f = face](std::size_t i) { return mesh.points[3 * f[i] + axis]; };
      inWall = inWall || (at(0) == box.lower[axis] && at(1) == box.lower[axis] && at(2) == box.lower[axis]) ||
               (at(0) == box.upper[axis] && at(1) == box.upper[axis] && at(2) == box.upper[axis]);
    }
    ASSERT_TRUE(inWall) << "a hanging face at vertex " << face[0];
  }
}

template<typename T>
void expectSameBytes(const Buffer<T>& a, const Buffer<T>& b)
{
  ASSERT_EQ(a.size(), b.size());
  // Empty buffers have no address, which memcmp must not get.
  const auto bytes = static_cast<std::size_t>(a.size()) * sizeof(T);
  EXPECT_TRUE(bytes == 0 || std::memcmp(a.data(), b.data(), bytes) == 0);
}

inline void expectSameMesh(const Mesh& a, const Mesh& b)
{
  expectSameBytes(a.points, b.points);
  expectSameBytes(a.tetrahedra, b.tetrahedra);
  expectSameBytes(a.vertexMaterial, b.vertexMaterial);
  expectSameBytes(a.cellMaterial, b.cellMaterial);
  expectSameBytes(a.cellLevel, b.cellLevel);
  expectSameBytes(a.cellInterfaceError, b.cellInterfaceError);
  for (std::size_t m = 0; m < a.materials.size(); ++m)
  {
    expectSameBytes(a.distances[m], b.distances[m]);
    expectSameBytes(a.ghosts[m], b.ghosts[m]);
    for (std::size_t f = 0; f < a.fields.size(); ++f)
    {
      expectSameBytes(a.values[f][m], b.values[f][m]);
    }
  }
  for (std::size_t f = 0; f < a.fields.size(); ++f)
  {
    expectSameBytes(a.composite[f], b.composite[f]);
    expectSameBytes(a.cellFieldErrors[f], b.cellFieldErrors[f]);
  }
}

/// The places of all vertices: a finer mesh of the same hierarchy has all of a coarser one's.
inline std::set<std::array<double, 3>> placesOf(const Mesh& mesh)
{
  std::set<std::array<double, 3>> result;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    result.insert({ mesh.points[3 * v], mesh.points[3 * v + 1], mesh.points[3 * v + 2] });
  }
  return result;
}

inline void expectRefines(const Mesh& fine, const Mesh& coarse)
{
  const auto finePlaces = placesOf(fine);
  const auto coarsePlaces = placesOf(coarse);
  EXPECT_TRUE(std::includes(finePlaces.begin(), finePlaces.end(), coarsePlaces.begin(), coarsePlaces.end()));
}

/// Barycentric weights of a point in a tetrahedron, by ratios of volumes.
inline std::array<double, 4> weightsIn(const std::array<Vector, 4>& corners, const Vector& p)
{
  const double whole = volumeOf(corners);
  std::array<double, 4> result;
  for (std::size_t i = 0; i < 4; ++i)
  {
    std::array<Vector, 4> part = corners;
    part[i] = p;
    result[i] = volumeOf(part) / whole;
  }
  return result;
}
}
