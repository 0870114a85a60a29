#include "Geometry/CutPolygon.h"

#include <algorithm>
#include <limits>

namespace strata
{
namespace
{
std::uint8_t edge(int a, int b)
{
  return static_cast<std::uint8_t>(1u << a | 1u << b);
}

/// The other three corners, so that corner, a, b, c is an even permutation.
constexpr std::array<std::array<int, 3>, 4> othersOf{ { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } } };
}

void PolygonCut::cutTriangle(const std::array<std::int64_t, 3>& vertices, const CornerValues* functions, int count)
{
  // The absent fourth corner sorts last.
  points_.reset({ vertices[0], vertices[1], vertices[2], std::numeric_limits<std::int64_t>::max() }, 7u);
  points_.setFunctions(functions, count);
  whole_ = { { 1, 0 }, { 2, 0 }, { 4, 0 } };
  addRegions();
}

void PolygonCut::cutSection(const std::array<std::int64_t, 4>& vertices, const std::array<double, 4>& planeValues,
  const CornerValues* functions, int count)
{
  points_.reset(vertices);
  points_.setFunctions(functions, count);
  points_.setPlane(planeValues);
  startSection(planeValues);
  addRegions();
}

void PolygonCut::startSection(const std::array<double, 4>& planeValues)
{
  std::array<int, 4> positive;
  std::array<int, 4> negative;
  int positives = 0;
  int negatives = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    if (planeValues[points_.givenCorner(corner)] >= 0.0)
    {
      positive[positives++] = corner;
    }
    else
    {
      negative[negatives++] = corner;
    }
  }
  whole_.clear();
  if (positives == 1 || negatives == 1)
  {
    const int lone = positives == 1 ? positive[0] : negative[0];
    const std::array<int, 3>& others = othersOf[lone];
    whole_ = { { edge(lone, others[0]), 0 }, { edge(lone, others[1]), 0 }, { edge(lone, others[2]), 0 } };
    if (positives == 1)
    {
      std::swap(whole_[1], whole_[2]);
    }
  }
  else if (positives == 2)
  {
    const int a = positive[0];
    const int b = positive[1];
    const int c = negative[0];
    const int d = negative[1];
    whole_ = { { edge(b, c), 0 }, { edge(b, d), 0 }, { edge(a, d), 0 }, { edge(a, c), 0 } };
    const std::array<int, 3>& others = othersOf[a];
    const bool even =
      (others[0] == b && others[1] == c) || (others[1] == b && others[2] == c) || (others[2] == b && others[0] == c);
    if (!even)
    {
      std::reverse(whole_.begin(), whole_.end());
    }
  }
}

void PolygonCut::addRegions()
{
  regions_.clear();
  loops_.clear();
  for (int function : points_.candidates())
  {
    region_ = whole_;
    for (int other : points_.candidates())
    {
      if (other != function && !region_.empty())
      {
        points_.signs(region_, function, other, signs_);
        clip(other);
      }
    }
    loop_.clear();
    for (const SymbolicVertex& vertex : region_)
    {
      loop_.push_back(points_.pointOf(vertex, function));
    }
    const int begin = static_cast<int>(loops_.size());
    if (points_.appendLoop(loop_, loops_))
    {
      regions_.push_back({ function, begin, static_cast<int>(loops_.size()) });
    }
  }
}

void PolygonCut::clip(int function)
{
  clipped_.clear();
  for (std::size_t i = 0; i < region_.size(); ++i)
  {
    const std::size_t next = i + 1 < region_.size() ? i + 1 : 0;
    if (signs_[i] > 0)
    {
      clipped_.push_back(region_[i]);
    }
    if (signs_[i] != signs_[next])
    {
      clipped_.push_back(SymbolicVertex::between(region_[i], region_[next], function));
    }
  }
  region_.swap(clipped_);
}
}
