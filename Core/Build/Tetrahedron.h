#pragma once

#include "Geometry/Box.h"
#include "Geometry/Vector.h"

#include <Eigen/Geometry>
#include <array>

namespace strata
{
/// A linear function: value(p) = constant + gradient . p.
struct LinearFunction
{
  double constant = 0.0;
  Vector gradient = Vector::Zero();

  double operator()(const Vector& p) const { return constant + gradient.dot(p); }
};

/// The four barycentric coordinates of a tetrahedron as linear functions of the place.
struct Barycentric
{
  std::array<LinearFunction, 4> weights;
  Box box; ///< round the tetrahedron

  explicit Barycentric(const std::array<Vector, 4>& corners)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Vector& a = corners[(i + 1) % 4];
      const Vector normal = (corners[(i + 2) % 4] - a).cross(corners[(i + 3) % 4] - a);
      weights[i].gradient = normal / normal.dot(corners[i] - a);
      weights[i].constant = -weights[i].gradient.dot(a);
      box.add(corners[i]);
    }
  }

  /// The linear function with the given values at the corners.
  template<typename Number>
  LinearFunction interpolant(const std::array<Number, 4>& values) const
  {
    LinearFunction result;
    for (std::size_t i = 0; i < 4; ++i)
    {
      result.constant += static_cast<double>(values[i]) * weights[i].constant;
      result.gradient += static_cast<double>(values[i]) * weights[i].gradient;
    }
    return result;
  }

  bool contains(const Vector& p, double tolerance) const
  {
    for (const LinearFunction& weight : weights)
    {
      if (weight(p) < -tolerance)
      {
        return false;
      }
    }
    return true;
  }
};
}
