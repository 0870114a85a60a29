#pragma once

#include "Geometry/Box.h"
#include "Model/Ids.h"

#include <array>
#include <cstddef>

namespace strata
{
/// A vertex of the lattice, in units of 2^-octaves of a base cube's edges.
struct LatticePoint
{
  std::array<std::int32_t, 3> at = { 0, 0, 0 };

  std::int32_t operator[](int axis) const { return at[static_cast<std::size_t>(axis)]; }
  std::int32_t& operator[](int axis) { return at[static_cast<std::size_t>(axis)]; }
  friend bool operator==(const LatticePoint& a, const LatticePoint& b) { return a.at == b.at; }
};

/// Up to four lattice points.
struct LatticePoints
{
  std::array<LatticePoint, 4> points;
  int count = 0;

  const LatticePoint* begin() const { return points.data(); }
  const LatticePoint* end() const { return points.data() + count; }
  void add(const LatticePoint& point) { points[static_cast<std::size_t>(count++)] = point; }
};

/// The integer lattice that carries the hierarchy: the box is cut into base cubes, each cube into six Kuhn
/// tetrahedra, which bisection splits down to `octaves` halvings of every edge (design 3.1).
struct Lattice
{
  static constexpr int octaves = 20;
  static constexpr std::int32_t cubeSize = 1 << octaves;
  /// Bisections below the base mesh after which an edge would be cut between lattice points.
  static constexpr int maximumLevel = 3 * octaves - 1;
  /// Keeps every coordinate within 31 bits.
  static constexpr int maximumCubes = 1024;

  Box box;
  std::array<int, 3> cubes = { 1, 1, 1 };

  Vector position(const LatticePoint& point) const;
  bool contains(const LatticePoint& point) const;
  /// The centres of the diamonds that must be split before all tetrahedra round the diamond at `center` exist.
  /// Empty for the diamonds of the base mesh.
  LatticePoints parents(const LatticePoint& center) const;
};

/// The midpoint of a split edge.
LatticePoint midpoint(const LatticePoint& a, const LatticePoint& b);
}
