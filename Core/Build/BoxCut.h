#pragma once

#include "Build/Tetrahedron.h"
#include "Geometry/Box.h"

#include <vector>

namespace strata
{
/// A multilinear function on the unit cube.
class MultilinearFunction
{
public:
  /// `values[i]` belongs to the corner whose coordinate along axis a is bit a of i.
  explicit MultilinearFunction(const std::array<double, 8>& values);

  double operator()(const Vector& u) const;
  /// The largest absolute value on the segment from a to b: exact, since the function is a cubic polynomial there.
  double largestAbsoluteValue(const Vector& a, const Vector& b) const;

private:
  /// Of 1, u, v, uv, w, uw, vw, uvw.
  std::array<double, 8> coefficients_;
};

/// The largest |c0 + c1 t + c2 t^2 + c3 t^3| for t in [0, 1].
double largestAbsoluteValue(const std::array<double, 4>& cubic);

/// Where a tetrahedron and an axis-aligned box meet, in the box's own coordinates (its corners are 0 and 1).
class BoxCut
{
public:
  struct Edge
  {
    Vector a;
    Vector b;
  };

  BoxCut(const std::array<Vector, 4>& corners, const Barycentric& barycentric, const Box& box);

  /// Whether the box meets the box round the tetrahedron.
  bool empty() const { return (lower_.array() > upper_.array()).any(); }
  /// Corners of the part of the box that lies in the box round the tetrahedron, numbered like the values of a
  /// MultilinearFunction.
  Vector innerCorner(std::size_t i) const;
  /// The edges of the intersection. A function that is linear along each axis has its largest absolute value over
  /// the intersection on them if every face of the tetrahedron is parallel to some axis (algorithms, 2.3).
  const std::vector<Edge>& edges();

private:
  void addFace(std::size_t opposite);
  void addBoxEdges();

  const Barycentric& barycentric_;
  Box box_;
  std::array<Vector, 4> corners_; ///< of the tetrahedron, in the box's coordinates
  Vector lower_;
  Vector upper_;
  bool haveEdges_ = false;
  std::vector<Edge> edges_;
};
}
