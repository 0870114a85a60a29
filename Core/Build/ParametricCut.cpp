#include "Build/ParametricCut.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace strata
{
namespace
{
/// What lies this far outside in barycentric coordinates counts as inside.
constexpr double tolerance = 1e-10;
/// How far above the maximum a bound may be, relative to it.
constexpr double looseness = 0.1;
constexpr int maximumBisections = 2000;

using Weights = std::array<double, 4>;

/// Adds the ends of the part of a segment on which all of some linear functions are positive. `a` and `b` are its ends
/// as results, `va` and `vb` the functions' values there.
void addEnds(const Weights& a, const Weights& b, const Weights& va, const Weights& vb, std::vector<Weights>& points)
{
  double from = 0.0;
  double to = 1.0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const double start = va[k] + tolerance;
    const double end = vb[k] + tolerance;
    to = end < 0.0 ? std::min(to, start < 0.0 ? -1.0 : start / (start - end)) : to;
    from = start < 0.0 && end >= 0.0 ? std::max(from, start / (start - end)) : from;
  }
  if (from > to)
  {
    return;
  }
  for (const double t : { from, to })
  {
    Weights point;
    for (std::size_t k = 0; k < 4; ++k)
    {
      point[k] = a[k] + t * (b[k] - a[k]);
    }
    points.push_back(point);
  }
}

Weights weightsAt(const Barycentric& barycentric, const Vector& p)
{
  return { barycentric.weights[0](p), barycentric.weights[1](p), barycentric.weights[2](p), barycentric.weights[3](p) };
}

/// A box of a hexahedron's parameters: the values at its corners of the cell's barycentric coordinates, then of the
/// function's components.
struct Part
{
  std::vector<CornerNumbers> values;
  double bound = 0.0; ///< of the function's length
  int axis = 0;       ///< along which it is split next

  friend bool operator<(const Part& a, const Part& b) { return a.bound < b.bound; }

  bool misses() const
  {
    return std::any_of(values.begin(), values.begin() + 4, [](const CornerNumbers& weight) {
      return std::all_of(weight.begin(), weight.end(), [](double w) { return w < -tolerance; });
    });
  }
  double lengthAt(std::size_t corner) const
  {
    double squared = 0.0;
    for (std::size_t c = 4; c < values.size(); ++c)
    {
      squared += values[c][corner] * values[c][corner];
    }
    return std::sqrt(squared);
  }
  bool cornerIsInside(std::size_t corner) const
  {
    return std::all_of(
      values.begin(), values.begin() + 4, [&](const CornerNumbers& weight) { return weight[corner] >= -tolerance; });
  }
  /// Finds the bound, and raises `reached` to lengths at corners within the cell.
  void measure(double& reached)
  {
    bound = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const double length = lengthAt(corner);
      bound = std::max(bound, length);
      reached = length > reached && cornerIsInside(corner) ? length : reached;
    }
  }
  Part half(bool upper) const
  {
    Part result = *this;
    const std::size_t bit = std::size_t{ 1 } << axis;
    for (CornerNumbers& value : result.values)
    {
      for (std::size_t i = 0; i < 8; ++i)
      {
        if ((i & bit) == 0)
        {
          value[upper ? i : i | bit] = 0.5 * (value[i] + value[i | bit]);
        }
      }
    }
    result.axis = (axis + 1) % 3;
    return result;
  }
};
}

TetrahedronCut::TetrahedronCut(
  const std::array<Vector, 4>& corners, const Barycentric& barycentric, const std::array<Vector, 8>& native)
{
  const std::array<Vector, 4> own = { native[0], native[1], native[2], native[3] };
  const Barycentric nativeBarycentric(own);
  if (!nativeBarycentric.weights[0].gradient.allFinite())
  {
    // Flat: the cells round it hold its points.
    return;
  }
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Weights a = weightsAt(nativeBarycentric, corners[i]);
      const Weights b = weightsAt(nativeBarycentric, corners[j]);
      addEnds(a, b, a, b, points_);
      Weights unitA{};
      Weights unitB{};
      unitA[i] = 1.0;
      unitB[j] = 1.0;
      addEnds(unitA, unitB, weightsAt(barycentric, own[i]), weightsAt(barycentric, own[j]), points_);
    }
  }
}

double TetrahedronCut::largestLength(const std::vector<CornerNumbers>& components) const
{
  double largest2 = 0.0;
  for (const Weights& point : points_)
  {
    double squared = 0.0;
    for (const CornerNumbers& values : components)
    {
      const double value = values[0] * point[0] + values[1] * point[1] + values[2] * point[2] + values[3] * point[3];
      squared += value * value;
    }
    largest2 = std::max(largest2, squared);
  }
  return std::sqrt(largest2);
}

HexahedronCut::HexahedronCut(const Barycentric& barycentric, const std::array<Vector, 8>& native)
{
  for (std::size_t k = 0; k < 4; ++k)
  {
    for (std::size_t i = 0; i < 8; ++i)
    {
      weights_[k][i] = barycentric.weights[k](native[i]);
    }
  }
}

double HexahedronCut::largestLength(const std::vector<CornerNumbers>& components, double known) const
{
  Part whole;
  whole.values.assign(weights_.begin(), weights_.end());
  whole.values.insert(whole.values.end(), components.begin(), components.end());
  if (whole.misses())
  {
    return 0.0;
  }
  double reached = 0.0;
  whole.measure(reached);
  std::priority_queue<Part> parts;
  parts.push(std::move(whole));
  for (int bisection = 0; !parts.empty(); ++bisection)
  {
    const double enough = std::max(known, reached * (1.0 + looseness));
    if (parts.top().bound <= enough || bisection == maximumBisections)
    {
      return parts.top().bound;
    }
    const Part part = parts.top();
    parts.pop();
    for (const bool upper : { false, true })
    {
      Part half = part.half(upper);
      if (!half.misses())
      {
        half.measure(reached);
        parts.push(std::move(half));
      }
    }
  }
  return 0.0;
}
}
