#pragma once

#include "Geometry/Box.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace strata::test
{
/// Part of a box on the side n.x <= d of a plane, 0 to 1: exact (the sum over the corners of signed cubes).
inline double fractionBelowPlane(const Box& box, const Vector& normal, double d)
{
  Vector n = normal.cwiseProduct(box.size());
  double rest = d - normal.dot(box.lower);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (n[axis] < 0.0) // mirror the unit cube
    {
      rest -= n[axis];
      n[axis] = -n[axis];
    }
  }
  const double sum = n.sum();
  if (rest <= 0.0 || rest >= sum)
  {
    return rest <= 0.0 ? 0.0 : 1.0;
  }
  std::sort(n.data(), n.data() + 3);
  const auto power = [](double x, int p) { return x > 0.0 ? std::pow(x, p) : 0.0; };
  const double tiny = 1e-9 * sum;
  if (n[1] <= tiny)
  {
    return rest / n[2];
  }
  if (n[0] <= tiny)
  {
    return (power(rest, 2) - power(rest - n[1], 2) - power(rest - n[2], 2)) / (2.0 * n[1] * n[2]);
  }
  double cubes = power(rest, 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    cubes -= power(rest - n[axis], 3);
    cubes += power(rest - sum + n[axis], 3);
  }
  return std::clamp(cubes / (6.0 * n.prod()), 0.0, 1.0);
}

/// Part of a box where a function with slope at most 1 is negative: boxes are halved `depth` times along each
/// axis where the sign may change, and the function is taken as linear in the smallest ones.
inline double fractionInside(const Box& box, const std::function<double(const Vector&)>& distance, int depth)
{
  const Vector center = box.center();
  const double here = distance(center);
  if (std::abs(here) > 0.5 * box.diagonal())
  {
    return here < 0.0 ? 1.0 : 0.0;
  }
  if (depth == 0)
  {
    Vector gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector step = 0.25 * box.size()[axis] * Vector::Unit(axis);
      gradient[axis] = (distance(center + step) - distance(center - step)) / (2.0 * step[axis]);
    }
    return fractionBelowPlane(box, gradient, gradient.dot(center) - here);
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    Box part = box;
    for (int axis = 0; axis < 3; ++axis)
    {
      ((corner >> axis) & 1 ? part.lower : part.upper)[axis] = center[axis];
    }
    sum += fractionInside(part, distance, depth - 1);
  }
  return sum / 8.0;
}
}
