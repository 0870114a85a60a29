#pragma once

#include "Build/Tetrahedron.h"
#include "Geometry/Box.h"

namespace strata
{
/// A polynomial c0 + c1 t + c2 t^2 + c3 t^3 on [0, 1].
struct Cubic
{
  double c0;
  double c1;
  double c2;
  double c3;

  /// Exact.
  double largestAbsoluteValue() const;
  /// An upper bound of that: the largest coefficient in Bernstein's form.
  double quickBound() const;
};

/// A multilinear function on the unit cube.
class MultilinearFunction
{
public:
  /// `values[i]` belongs to the corner whose coordinate along axis a is bit a of i.
  explicit MultilinearFunction(const std::array<double, 8>& values);

  double operator()(const Vector& u) const;
  /// The function along the segment from a to b, as a polynomial of t in [0, 1].
  Cubic along(const Vector& a, const Vector& b) const;

private:
  /// Of 1, u, v, uv, w, uw, vw, uvw.
  std::array<double, 8> coefficients_;
};

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
  const Edge* begin();
  const Edge* end() { return begin() + edgeCount_; }

private:
  void findEdges();
  void addWithin(const Vector& a, const Vector& b);
  void addSide(int axis, double limit);
  void addBoxEdges();
  void addBoxEdge(const Vector& a, const Vector& b);
  void add(const Vector& a, const Vector& b) { edges_[edgeCount_++] = { a, b }; }

  const Barycentric& barycentric_;
  Box box_;
  std::array<Vector, 4> corners_; ///< of the tetrahedron, in the box's coordinates
  Vector lower_;
  Vector upper_;
  std::array<std::array<bool, 2>, 3> cuts_{}; ///< whether the box's lower and upper side reach the tetrahedron
  bool haveEdges_ = false;
  std::size_t edgeCount_ = 0;
  /// Six edges of the tetrahedron, twelve of the box, and six sides of the box on each of four faces.
  std::array<Edge, 6 + 12 + 24> edges_;
};
}
