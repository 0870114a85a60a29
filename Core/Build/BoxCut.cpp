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

/// The part of a segment on which linear functions are not negative.
struct Range
{
  double from = 0.0;
  double to = 1.0;

  /// The function's values at the ends of the segment.
  void clip(double start, double end)
  {
    to = end < 0.0 ? std::min(to, start < 0.0 ? -1.0 : start / (start - end)) : to;
    from = start < 0.0 && end >= 0.0 ? std::max(from, start / (start - end)) : from;
  }
  bool empty() const { return from > to; }
};

}

double Cubic::largestAbsoluteValue() const
{
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

double Cubic::quickBound() const
{
  return std::max(
    { std::abs(c0), std::abs(c0 + c1 / 3.0), std::abs(c0 + (2.0 * c1 + c2) / 3.0), std::abs(c0 + c1 + c2 + c3) });
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

Cubic MultilinearFunction::along(const Vector& a, const Vector& b) const
{
  const Vector d = b - a;
  const auto& c = coefficients_;
  // Along the segment, multiplied out axis by axis.
  const auto line = [&](std::size_t i) { return std::array<double, 2>{ c[i] + c[i + 1] * a[0], c[i + 1] * d[0] }; };
  const auto plane = [&](std::size_t i) {
    const std::array<double, 2> first = line(i);
    const std::array<double, 2> second = line(i + 2);
    return std::array<double, 3>{ first[0] + second[0] * a[1], first[1] + second[1] * a[1] + second[0] * d[1],
      second[1] * d[1] };
  };
  const std::array<double, 3> lower = plane(0);
  const std::array<double, 3> upper = plane(4);
  return { lower[0] + upper[0] * a[2], lower[1] + upper[1] * a[2] + upper[0] * d[2],
    lower[2] + upper[2] * a[2] + upper[1] * d[2], upper[2] * d[2] };
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

const BoxCut::Edge* BoxCut::begin()
{
  if (!haveEdges_)
  {
    haveEdges_ = true;
    findEdges();
  }
  return edges_.data();
}

void BoxCut::findEdges()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    cuts_[static_cast<std::size_t>(axis)] = { lower_[axis] <= 0.0, upper_[axis] >= 1.0 };
  }
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      addWithin(corners_[i], corners_[j]);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t side = 0; side < 2; ++side)
    {
      if (cuts_[static_cast<std::size_t>(axis)][side])
      {
        addSide(axis, static_cast<double>(side));
      }
    }
  }
  addBoxEdges();
}

/// Adds the part of a segment that lies in the box.
void BoxCut::addWithin(const Vector& a, const Vector& b)
{
  Range range;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& [lower, upper] = cuts_[static_cast<std::size_t>(axis)];
    if (lower)
    {
      range.clip(a[axis] + tolerance, b[axis] + tolerance);
    }
    if (upper)
    {
      range.clip(1.0 + tolerance - a[axis], 1.0 + tolerance - b[axis]);
    }
  }
  if (!range.empty())
  {
    add(a + range.from * (b - a), a + range.to * (b - a));
  }
}

/// Adds the edges in which a side of the box cuts the faces of the tetrahedron.
void BoxCut::addSide(int axis, double limit)
{
  for (std::size_t opposite = 0; opposite < 4; ++opposite)
  {
    std::array<Vector, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 1; i < 4; ++i)
    {
      const Vector& a = corners_[(opposite + i) % 4];
      const Vector& b = corners_[(opposite + i % 3 + 1) % 4];
      const double da = a[axis] - limit;
      const double db = b[axis] - limit;
      if ((da < 0.0) != (db < 0.0))
      {
        ends[count] = a + (b - a) * (da / (da - db));
        ends[count++][axis] = limit;
      }
    }
    if (count == 2)
    {
      addWithin(ends[0], ends[1]);
    }
  }
}

void BoxCut::addBoxEdges()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int second = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    for (std::size_t edge = 0; edge < 4; ++edge)
    {
      // It lies on two sides of the box, both of which must cut the tetrahedron.
      if (cuts_[static_cast<std::size_t>(second)][edge & 1] && cuts_[static_cast<std::size_t>(third)][edge >> 1])
      {
        Vector start = Vector::Zero();
        start[second] = static_cast<double>(edge & 1);
        start[third] = static_cast<double>(edge >> 1);
        addBoxEdge(start, start + Vector::Unit(axis));
      }
    }
  }
}

/// Adds the part of an edge of the box that lies in the tetrahedron.
void BoxCut::addBoxEdge(const Vector& a, const Vector& b)
{
  const Vector placeA = box_.lower + a.cwiseProduct(box_.size());
  const Vector placeB = box_.lower + b.cwiseProduct(box_.size());
  Range range;
  for (const LinearFunction& weight : barycentric_.weights)
  {
    range.clip(weight(placeA) + tolerance, weight(placeB) + tolerance);
  }
  if (!range.empty())
  {
    add(a + range.from * (b - a), a + range.to * (b - a));
  }
}
}
