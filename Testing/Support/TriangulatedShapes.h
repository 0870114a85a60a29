#pragma once

#include "Geometry/Vector.h"

#include <array>
#include <cmath>
#include <vector>

namespace strata::test
{
using Triangles = std::vector<std::array<Vector, 3>>;

/// The parallelogram with corner `origin` and sides `u`, `v`, as n x n x 2 triangles with normal u x v.
inline Triangles parallelogram(const Vector& origin, const Vector& u, const Vector& v, int n)
{
  Triangles result;
  const auto at = [&](int i, int j) { return Vector(origin + u * (double(i) / n) + v * (double(j) / n)); };
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      result.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      result.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return result;
}

/// The surface of an axis-aligned cube with edge 1 and the given lower corner; normals point outward.
inline Triangles cubeSurface(const Vector& lower, int n)
{
  Triangles result;
  const std::array<Vector, 3> axes = { Vector::UnitX(), Vector::UnitY(), Vector::UnitZ() };
  for (int a = 0; a < 3; ++a)
  {
    const Vector& u = axes[(a + 1) % 3];
    const Vector& v = axes[(a + 2) % 3];
    for (const auto& triangles : { parallelogram(lower, v, u, n), parallelogram(lower + axes[a], u, v, n) })
    {
      result.insert(result.end(), triangles.begin(), triangles.end());
    }
  }
  return result;
}

/// A sphere inscribed with triangles: a regular icosahedron whose faces are split in four `subdivisions` times, its
/// vertices pushed out to the radius. Normals point outward.
inline Triangles sphereSurface(const Vector& center, double radius, int subdivisions)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const std::array<Vector, 12> corners = { Vector(-1, g, 0), Vector(1, g, 0), Vector(-1, -g, 0), Vector(1, -g, 0),
    Vector(0, -1, g), Vector(0, 1, g), Vector(0, -1, -g), Vector(0, 1, -g), Vector(g, 0, -1), Vector(g, 0, 1),
    Vector(-g, 0, -1), Vector(-g, 0, 1) };
  constexpr std::array<std::array<int, 3>, 20> faces = { { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 },
    { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } } };
  Triangles unit;
  for (const auto& face : faces)
  {
    unit.push_back({ corners[face[0]].normalized(), corners[face[1]].normalized(), corners[face[2]].normalized() });
  }
  for (int s = 0; s < subdivisions; ++s)
  {
    Triangles finer;
    for (const auto& [a, b, c] : unit)
    {
      const Vector ab = (a + b).normalized();
      const Vector bc = (b + c).normalized();
      const Vector ca = (c + a).normalized();
      finer.insert(finer.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
    }
    unit = std::move(finer);
  }
  for (auto& triangle : unit)
  {
    for (Vector& corner : triangle)
    {
      corner = center + radius * corner;
    }
  }
  return unit;
}
}
