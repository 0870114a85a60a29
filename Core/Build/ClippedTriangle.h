#pragma once

#include "Build/Tetrahedron.h"

namespace strata
{
/// Elements this close to a cell's face (in barycentric coordinates) lie on it.
constexpr double faceTolerance = 1e-9;

/// The part of a triangle within a cell: a convex polygon, empty where they don't meet.
class ClippedTriangle
{
public:
  ClippedTriangle(const Barycentric& cell, const std::array<Vector, 3>& triangle);

  bool empty() const { return size_ == 0; }
  /// Whether the triangle lies in the cell as a whole.
  bool whole() const { return whole_; }
  const Vector* begin() const { return corners_.data(); }
  const Vector* end() const { return corners_.data() + size_; }

private:
  void clip(const LinearFunction& weight);

  /// A triangle clipped by four half-spaces has at most seven corners; rounding may add a few.
  std::array<Vector, 16> corners_;
  std::size_t size_ = 3;
  bool whole_ = true;
};
}
