#pragma once

#include "Geometry/Vector.h"

#include <limits>

namespace strata
{
/// An axis-aligned box; empty until a point is added.
struct Box
{
  Vector lower = Vector::Constant(std::numeric_limits<double>::infinity());
  Vector upper = Vector::Constant(-std::numeric_limits<double>::infinity());

  bool empty() const { return (lower.array() > upper.array()).any(); }
  Vector size() const { return upper - lower; }
  Vector center() const { return 0.5 * (lower + upper); }
  double diagonal() const { return empty() ? 0.0 : size().norm(); }
  double volume() const { return empty() ? 0.0 : size().prod(); }

  void add(const Vector& point)
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  void add(const Box& box)
  {
    lower = lower.cwiseMin(box.lower);
    upper = upper.cwiseMax(box.upper);
  }
  bool contains(const Vector& point) const
  {
    return (point.array() >= lower.array()).all() && (point.array() <= upper.array()).all();
  }
  /// Squared distance from a point to the box; 0 inside.
  double squaredDistance(const Vector& point) const
  {
    return (lower - point).cwiseMax(point - upper).cwiseMax(0.0).squaredNorm();
  }
};
}
