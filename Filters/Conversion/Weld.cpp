#include "Conversion/Weld.h"

#include "Geometry/Box.h"

#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace strata::conversion
{
namespace
{
using BinIndex = std::array<std::int64_t, 3>;

struct BinHash
{
  std::size_t operator()(const BinIndex& bin) const
  {
    std::uint64_t hash = 0;
    for (const std::int64_t i : bin)
    {
      hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15ull;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// Bins are far wider than the tolerance, so that nearly every point has to look into one only.
class Bins
{
public:
  Bins(const std::vector<Vector>& points, double tolerance) :
    points_(points), tolerance_(tolerance), next_(points.size(), -1)
  {
    Box box;
    for (const Vector& point : points)
    {
      box.add(point);
    }
    lower_ = box.empty() ? Vector(Vector::Zero()) : box.lower;
    const double smallest = std::max(box.diagonal() * 1e-12, std::numeric_limits<double>::min());
    width_ = std::max(1000.0 * tolerance, smallest);
    heads_.reserve(points.size());
  }

  Index findOrInsert(Index i)
  {
    const Vector& point = points_[static_cast<std::size_t>(i)];
    const BinIndex from = bin(point.array() - tolerance_);
    const BinIndex to = bin(point.array() + tolerance_);
    BinIndex at;
    for (at[0] = from[0]; at[0] <= to[0]; ++at[0])
      for (at[1] = from[1]; at[1] <= to[1]; ++at[1])
        for (at[2] = from[2]; at[2] <= to[2]; ++at[2])
        {
          const Index found = find(at, point);
          if (found >= 0)
          {
            return found;
          }
        }
    const auto [head, isNew] = heads_.try_emplace(bin(point), i);
    if (!isNew)
    {
      next_[static_cast<std::size_t>(i)] = head->second;
      head->second = i;
    }
    return i;
  }

private:
  BinIndex bin(const Vector& point) const
  {
    const Vector scaled = (point - lower_) / width_;
    return { static_cast<std::int64_t>(std::floor(scaled[0])), static_cast<std::int64_t>(std::floor(scaled[1])),
      static_cast<std::int64_t>(std::floor(scaled[2])) };
  }

  Index find(const BinIndex& at, const Vector& point) const
  {
    const auto head = heads_.find(at);
    Index i = head == heads_.end() ? -1 : head->second;
    while (i >= 0 && (points_[static_cast<std::size_t>(i)] - point).squaredNorm() > tolerance_ * tolerance_)
    {
      i = next_[static_cast<std::size_t>(i)];
    }
    return i;
  }

  const std::vector<Vector>& points_;
  double tolerance_;
  double width_ = 1.0;
  Vector lower_;
  std::unordered_map<BinIndex, Index, BinHash> heads_;
  std::vector<Index> next_;
};
}

std::vector<Index> weld(const std::vector<Vector>& points, double tolerance)
{
  std::vector<Index> result(points.size());
  Bins bins(points, tolerance);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result[i] = bins.findOrInsert(static_cast<Index>(i));
  }
  return result;
}
}
