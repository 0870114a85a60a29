#include "Build/ParametricCut.h"

#include "Build/BoxCut.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace strata
{
namespace
{
/// What lies this far outside in barycentric coordinates counts as inside.
constexpr double tolerance = 1e-10;
/// How far above the maximum a bound may be, relative to it.
constexpr double looseness = 0.2;

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

/// The smallest of max_i (values[i] + x slopes[i]) over x >= 0, as the x at which it is reached.
double lowestMaximum(const CornerNumbers& values, const CornerNumbers& slopes)
{
  double x = 0.0;
  std::size_t top = 0;
  for (std::size_t i = 1; i < 8; ++i)
  {
    top = values[i] > values[top] || (values[i] == values[top] && slopes[i] > slopes[top]) ? i : top;
  }
  // Along the maximum while it falls, from line to steeper line.
  while (slopes[top] < 0.0)
  {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t next = top;
    for (std::size_t i = 0; i < 8; ++i)
    {
      const double crossing = (values[top] - values[i]) / (slopes[i] - slopes[top]);
      if (slopes[i] > slopes[top] && crossing < nearest)
      {
        nearest = crossing;
        next = i;
      }
    }
    if (next == top)
    {
      return x;
    }
    x = std::max(x, nearest);
    top = next;
  }
  return x;
}

/// An upper bound of a multilinear function within the cell, from the corners of a box of parameters. Adding
/// non-negative multiples of the cell's barycentric coordinates raises the function within the cell and may lower it
/// beyond, at the corners that rule the bound; the multiples are found one at a time.
double boundWithin(CornerNumbers values, const std::array<CornerNumbers, 4>& weights)
{
  constexpr int sweeps = 2;
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (const CornerNumbers& weight : weights)
    {
      if (*std::min_element(weight.begin(), weight.end()) >= 0.0)
      {
        continue;
      }
      const double multiple = lowestMaximum(values, weight);
      for (std::size_t i = 0; i < 8; ++i)
      {
        values[i] += multiple * weight[i];
      }
    }
  }
  return *std::max_element(values.begin(), values.end());
}

/// A box of a hexahedron's parameters.
struct Part
{
  Vector lower;
  Vector upper;
  double bound; ///< of the function's length

  friend bool operator<(const Part& a, const Part& b) { return a.bound < b.bound; }

  CornerNumbers cornersOf(const MultilinearFunction& function) const
  {
    CornerNumbers result;
    for (std::size_t i = 0; i < 8; ++i)
    {
      result[i] = function(
        { (i & 1) != 0 ? upper[0] : lower[0], (i & 2) != 0 ? upper[1] : lower[1], (i & 4) != 0 ? upper[2] : lower[2] });
    }
    return result;
  }
};

/// Finds the largest length of a function within the cell by bisection of the parameters.
class Bisection
{
public:
  Bisection(const std::array<CornerNumbers, 4>& weights, const std::vector<CornerNumbers>& components, double known) :
    functions_(components.begin(), components.end()), known_(known), values_(components.size())
  {
    for (const CornerNumbers& weight : weights)
    {
      weights_.emplace_back(weight);
    }
  }

  HexahedronCut::Bounds run(int bisections)
  {
    consider({ Vector::Zero(), Vector::Ones(), 0.0 });
    for (int done = 0; !parts_.empty(); ++done)
    {
      const Part part = parts_.top();
      if (part.bound <= enough() || done == bisections)
      {
        return { std::max(part.bound, covered_), reached_ };
      }
      parts_.pop();
      Eigen::Index axis = 0;
      (part.upper - part.lower).maxCoeff(&axis);
      const double middle = 0.5 * (part.lower[axis] + part.upper[axis]);
      Part half = part;
      half.upper[axis] = middle;
      consider(half);
      half = part;
      half.lower[axis] = middle;
      consider(half);
    }
    return { covered_, reached_ };
  }

private:
  double enough() const { return std::max(known_, reached_ * (1.0 + looseness)); }

  /// Keeps a part that may hold a larger length than is known.
  void consider(Part part)
  {
    std::array<CornerNumbers, 4> weights;
    for (std::size_t k = 0; k < 4; ++k)
    {
      weights[k] = part.cornersOf(weights_[k]);
      for (double& weight : weights[k])
      {
        weight += tolerance;
      }
      if (*std::max_element(weights[k].begin(), weights[k].end()) < 0.0)
      {
        return;
      }
    }
    std::transform(functions_.begin(), functions_.end(), values_.begin(),
      [&](const MultilinearFunction& function) { return part.cornersOf(function); });
    double atCorners = 0.0;
    for (std::size_t i = 0; i < 8; ++i)
    {
      double squared = 0.0;
      for (const CornerNumbers& value : values_)
      {
        squared += value[i] * value[i];
      }
      atCorners = std::max(atCorners, squared);
      const bool inside =
        std::all_of(weights.begin(), weights.end(), [&](const CornerNumbers& weight) { return weight[i] >= 0.0; });
      reached_ = inside ? std::max(reached_, std::sqrt(squared)) : reached_;
    }
    part.bound = std::sqrt(atCorners);
    part.bound = part.bound > enough() ? std::min(part.bound, boundOfComponents(weights)) : part.bound;
    if (part.bound > enough())
    {
      parts_.push(part);
    }
    else
    {
      covered_ = std::max(covered_, part.bound);
    }
  }

  double boundOfComponents(const std::array<CornerNumbers, 4>& weights) const
  {
    double squared = 0.0;
    for (CornerNumbers value : values_)
    {
      double largest = boundWithin(value, weights);
      std::transform(value.begin(), value.end(), value.begin(), std::negate<double>());
      largest = std::max(largest, boundWithin(value, weights));
      squared += largest > 0.0 ? largest * largest : 0.0;
    }
    return std::sqrt(squared);
  }

  std::vector<MultilinearFunction> weights_;
  std::vector<MultilinearFunction> functions_;
  double known_;
  double reached_ = 0.0; ///< at a point within the cell
  double covered_ = 0.0; ///< bound of all parts that were left
  std::vector<CornerNumbers> values_;
  std::priority_queue<Part> parts_;
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

HexahedronCut::Bounds HexahedronCut::largestLength(
  const std::vector<CornerNumbers>& components, double known, int bisections) const
{
  return Bisection(weights_, components, known).run(bisections);
}
}
