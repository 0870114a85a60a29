#include "Build/BoxCut.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// What lies this far outside of the box, in its own coordinates, or of the tetrahedron, in barycentric ones, counts
/// as inside: edges on common faces must not get lost in rounding.
constexpr double tolerance = 1e-10;

/// A triangle clipped by six half-spaces has at most nine corners; rounding may add a few.
struct Polygon
{
  std::array<Vector, 20> corners;
  std::size_t size = 0;
};

/// Keeps the part where sign * (x[axis] - limit) <= 0.
void clip(Polygon& polygon, int axis, double limit, double sign)
{
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i)
  {
    const Vector& a = polygon.corners[i];
    const Vector& b = polygon.corners[(i + 1) % polygon.size];
    const double da = sign * (a[axis] - limit);
    const double db = sign * (b[axis] - limit);
    if (da <= 0.0)
    {
      kept.corners[kept.size++] = a;
    }
    if ((da <= 0.0) != (db <= 0.0))
    {
      kept.corners[kept.size] = a + (b - a) * (da / (da - db));
      kept.corners[kept.size++][axis] = limit;
    }
  }
  polygon = kept;
}
}

MultilinearFunction::MultilinearFunction(const std::array<double, 8>& values) : coefficients_(values)
{
  for (std::size_t bit = 1; bit < 8; bit *= 2)
  {
    for (std::size_t i = 0; i < 8; ++i)
    {
      coefficients_[i] -= (i & bit) != 0 ? coefficients_[i - bit] : 0.0;
    }
  }
}

double MultilinearFunction::operator()(const Vector& u) const
{
  const auto& c = coefficients_;
  return c[0] + c[1] * u[0] + (c[2] + c[3] * u[0]) * u[1] + (c[4] + c[5] * u[0] + (c[6] + c[7] * u[0]) * u[1]) * u[2];
}

double MultilinearFunction::largestAbsoluteValue(const Vector& a, const Vector& b) const
{
  const Vector d = b - a;
  const auto& c = coefficients_;
  // Along the segment, (p + q u) as polynomials of its parameter, multiplied out axis by axis.
  const auto along = [&](double p, double q) { return std::array<double, 2>{ p + q * a[0], q * d[0] }; };
  const auto plane = [&](std::size_t i) {
    const std::array<double, 2> first = along(c[i], c[i + 1]);
    const std::array<double, 2> second = along(c[i + 2], c[i + 3]);
    return std::array<double, 3>{ first[0] + second[0] * a[1], first[1] + second[1] * a[1] + second[0] * d[1],
      second[1] * d[1] };
  };
  const std::array<double, 3> lower = plane(0);
  const std::array<double, 3> upper = plane(4);
  return strata::largestAbsoluteValue({ lower[0] + upper[0] * a[2], lower[1] + upper[1] * a[2] + upper[0] * d[2],
    lower[2] + upper[2] * a[2] + upper[1] * d[2], upper[2] * d[2] });
}

double largestAbsoluteValue(const std::array<double, 4>& cubic)
{
  const auto [c0, c1, c2, c3] = cubic;
  const auto at = [&](double t) { return std::abs(c0 + t * (c1 + t * (c2 + t * c3))); };
  double largest = std::max(at(0.0), at(1.0));
  // Zeros of the derivative 3 c3 t^2 + 2 c2 t + c1, in the form that does not cancel.
  const double discriminant = c2 * c2 - 3.0 * c3 * c1;
  if (discriminant >= 0.0)
  {
    const double q = -(c2 + std::copysign(std::sqrt(discriminant), c2));
    for (const double t : { q / (3.0 * c3), c1 / q })
    {
      // Comparisons are false for the NaN and infinities of polynomials of lower degree.
      largest = t > 0.0 && t < 1.0 ? std::max(largest, at(t)) : largest;
    }
  }
  return largest;
}

BoxCut::BoxCut(const std::array<Vector, 4>& corners, const Barycentric& barycentric, const Box& box) :
  barycentric_(barycentric), box_(box), lower_(Vector::Ones()), upper_(Vector::Zero())
{
  const Vector inverseSize = box.size().cwiseInverse();
  for (std::size_t k = 0; k < 4; ++k)
  {
    corners_[k] = (corners[k] - box.lower).cwiseProduct(inverseSize);
  }
  lower_ = corners_[0].cwiseMin(corners_[1]).cwiseMin(corners_[2].cwiseMin(corners_[3])).cwiseMax(-tolerance);
  upper_ = corners_[0].cwiseMax(corners_[1]).cwiseMax(corners_[2].cwiseMax(corners_[3])).cwiseMin(1.0 + tolerance);
}

Vector BoxCut::innerCorner(std::size_t i) const
{
  return { (i & 1) != 0 ? upper_[0] : lower_[0], (i & 2) != 0 ? upper_[1] : lower_[1],
    (i & 4) != 0 ? upper_[2] : lower_[2] };
}

const std::vector<BoxCut::Edge>& BoxCut::edges()
{
  if (!haveEdges_)
  {
    haveEdges_ = true;
    for (std::size_t opposite = 0; opposite < 4; ++opposite)
    {
      addFace(opposite);
    }
    addBoxEdges();
  }
  return edges_;
}

void BoxCut::addFace(std::size_t opposite)
{
  Polygon polygon;
  for (std::size_t k = 0; k < 4; ++k)
  {
    if (k != opposite)
    {
      polygon.corners[polygon.size++] = corners_[k];
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    clip(polygon, axis, -tolerance, -1.0);
    clip(polygon, axis, 1.0 + tolerance, 1.0);
  }
  for (std::size_t i = 0; i < polygon.size; ++i)
  {
    edges_.push_back({ polygon.corners[i], polygon.corners[(i + 1) % polygon.size] });
  }
}

void BoxCut::addBoxEdges()
{
  std::array<std::array<double, 4>, 8> weights;
  std::array<Vector, 8> corners;
  for (std::size_t i = 0; i < 8; ++i)
  {
    corners[i] = { static_cast<double>(i & 1), static_cast<double>((i >> 1) & 1), static_cast<double>(i >> 2) };
    const Vector place = box_.lower + corners[i].cwiseProduct(box_.size());
    for (std::size_t k = 0; k < 4; ++k)
    {
      weights[i][k] = barycentric_.weights[k](place) + tolerance;
    }
  }
  for (std::size_t i = 0; i < 8; ++i)
  {
    for (std::size_t bit = 1; bit < 8; bit *= 2)
    {
      if ((i & bit) != 0)
      {
        continue;
      }
      double from = 0.0;
      double to = 1.0;
      for (std::size_t k = 0; k < 4; ++k)
      {
        const double start = weights[i][k];
        const double end = weights[i | bit][k];
        // Where the weight falls below zero, the edge leaves the tetrahedron; where it rises above, it enters.
        to = end < 0.0 ? std::min(to, start < 0.0 ? -1.0 : start / (start - end)) : to;
        from = start < 0.0 && end >= 0.0 ? std::max(from, start / (start - end)) : from;
      }
      if (from <= to)
      {
        const Vector direction = corners[i | bit] - corners[i];
        edges_.push_back({ corners[i] + from * direction, corners[i] + to * direction });
      }
    }
  }
}
}
