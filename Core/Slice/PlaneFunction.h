#pragma once

#include "Model/Representation.h"
#include "Slice/Slice.h"

#include <cmath>

namespace strata
{
/// The linear function that is zero on a plane. Its values depend on the plane and the vertex alone.
class PlaneFunction
{
public:
  explicit PlaneFunction(const SlicePlane& plane) :
    normal_(plane.normal), constant_(plane.normal.dot(plane.origin) + plane.offset)
  {}

  double operator()(const double* point) const
  {
    return normal_[0] * point[0] + normal_[1] * point[1] + normal_[2] * point[2] - constant_;
  }
  double operator()(const Representation& representation, Index vertex) const
  {
    return (*this)(representation.points + 3 * vertex);
  }
  /// Lower and upper bound of the values in a box, rounding included.
  void range(const Box& box, double& lower, double& upper) const
  {
    const Vector center = 0.5 * (box.lower + box.upper);
    const Vector half = 0.5 * (box.upper - box.lower);
    const Vector size = normal_.cwiseAbs();
    const double rounding = 1e-14 * (size.dot(center.cwiseAbs() + half) + std::abs(constant_));
    const double middle = (*this)(center.data());
    const double reach = size.dot(half) + rounding;
    lower = middle - reach;
    upper = middle + reach;
  }

private:
  Vector normal_;
  double constant_;
};
}
