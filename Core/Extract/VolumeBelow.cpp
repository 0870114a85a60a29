#include "Extract/VolumeBelow.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// The part of a tetrahedron with ascending corner heights h that lies below height x, and its derivative.
std::array<double, 2> partBelow(const std::array<double, 4>& h, double x)
{
  if (x <= h[0] || x >= h[3])
  {
    return { x <= h[0] ? 0.0 : 1.0, 0.0 };
  }
  if (x <= h[1])
  {
    const double scale = 1.0 / ((h[1] - h[0]) * (h[2] - h[0]) * (h[3] - h[0]));
    const double t = x - h[0];
    return { t * t * t * scale, 3.0 * t * t * scale };
  }
  if (x >= h[2])
  {
    const double scale = 1.0 / ((h[3] - h[0]) * (h[3] - h[1]) * (h[3] - h[2]));
    const double t = h[3] - x;
    return { 1.0 - t * t * t * scale, 3.0 * t * t * scale };
  }
  // Between the middle corners the cut is a quadrangle whose area is quadratic in x.
  const double a = h[1] - h[0];
  const double b = h[2] - h[0];
  const double c = h[3] - h[0];
  const double t = x - h[1];
  const double start = a * a / (b * c);
  const double slope = 3.0 * a / (b * c);
  const double bend = -3.0 * (b + c - a) / (b * c * (b - a) * (c - a)) * 1.0;
  const double linear = 3.0 / (b * c);
  return { start + t * (slope + t * (linear + t * bend / 3.0)), slope + t * (2.0 * linear + t * bend) };
}
}

VolumeBelow::VolumeBelow(const CellComplex& complex, std::int32_t cell, const Vector& normal)
{
  const Vector& center = complex.positions[complex.cellVertex(cell)];
  complex.forEachTetrahedron(cell, [&](std::int32_t, std::int32_t f, std::int32_t a, std::int32_t b) {
    const Vector u = complex.positions[f] - center;
    const Vector v = complex.positions[a] - center;
    const Vector w = complex.positions[b] - center;
    Tetrahedron tetrahedron{ { 0.0, normal.dot(u), normal.dot(v), normal.dot(w) }, u.dot(v.cross(w)) / 6.0 };
    std::sort(tetrahedron.heights.begin(), tetrahedron.heights.end());
    lowest_ = std::min(lowest_, tetrahedron.heights[0]);
    highest_ = std::max(highest_, tetrahedron.heights[3]);
    total_ += tetrahedron.volume;
    tetrahedra_.push_back(tetrahedron);
  });
}

std::array<double, 2> VolumeBelow::evaluate(double offset) const
{
  std::array<double, 2> sum{ 0.0, 0.0 };
  for (const Tetrahedron& tetrahedron : tetrahedra_)
  {
    const std::array<double, 2> part = partBelow(tetrahedron.heights, offset);
    sum[0] += tetrahedron.volume * part[0];
    sum[1] += tetrahedron.volume * part[1];
  }
  return sum;
}

double VolumeBelow::offset(double fraction) const
{
  constexpr int maximumSteps = 60;
  constexpr double tolerance = 1e-12;
  double low = lowest_;
  double high = highest_;
  double x = low + fraction * (high - low);
  for (int step = 0; step < maximumSteps; ++step)
  {
    const std::array<double, 2> value = evaluate(x);
    const double missing = fraction * total_ - value[0];
    if (std::abs(missing) <= tolerance * total_)
    {
      break;
    }
    (missing > 0.0 ? low : high) = x;
    const double newton = value[1] > 0.0 ? x + missing / value[1] : low;
    x = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return x;
}
}
