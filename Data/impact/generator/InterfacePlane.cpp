#include "InterfacePlane.h"

#include <algorithm>
#include <cmath>

namespace impact
{
double cubeVolume(double offset, std::array<double, 3> normal)
{
  std::sort(normal.begin(), normal.end());
  const auto [small, middle, large] = normal;
  const double a = offset;
  if (a <= 0)
  {
    return 0;
  }
  if (a >= small + middle + large)
  {
    return 1;
  }
  if (middle < 1e-5 * large)
  {
    return std::min(1.0, a / large);
  }
  const auto positive = [](double x) { return x > 0 ? x : 0; };
  if (small < 1e-5 * large)
  {
    const auto square = [&](double x) {
      const double y = positive(x);
      return y * y;
    };
    const double area = a * a - square(a - middle) - square(a - large) + square(a - middle - large);
    return std::clamp(area / (2 * middle * large), 0.0, 1.0);
  }
  const auto cube = [&](double x) {
    const double y = positive(x);
    return y * y * y;
  };
  const double volume = a * a * a - cube(a - small) - cube(a - middle) - cube(a - large) + cube(a - small - middle) +
                        cube(a - small - large) + cube(a - middle - large);
  return std::clamp(volume / (6 * small * middle * large), 0.0, 1.0);
}

InterfacePlane::InterfacePlane(const std::array<double, 3>& outward, double fraction)
{
  double sum = 0;
  for (int d = 0; d < 3; ++d)
  {
    flipped_[d] = outward[d] < 0;
    normal_[d] = std::fabs(outward[d]);
    sum += normal_[d];
  }
  if (sum < 1e-6)
  {
    normal_ = { 0, 0, 1 };
    sum = 1;
  }
  for (double& x : normal_)
  {
    x /= sum;
  }
  double low = 0;
  double high = 1;
  for (int iteration = 0; iteration < 44; ++iteration)
  {
    offset_ = 0.5 * (low + high);
    (cubeVolume(offset_, normal_) < fraction ? low : high) = offset_;
  }
}

double InterfacePlane::slabVolume(int axis, double from, double to) const
{
  if (flipped_[axis])
  {
    const double mirrored = 1 - from;
    from = 1 - to;
    to = mirrored;
  }
  std::array<double, 3> normal = normal_;
  normal[axis] *= to - from;
  return (to - from) * cubeVolume(offset_ - normal_[axis] * from, normal);
}
}
