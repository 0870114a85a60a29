#include "Geometry/CutPoints.h"

#include <algorithm>
#include <cassert>

namespace strata
{
namespace
{
/// Removes repeated points and spikes (p q p), so that every edge that is left bounds an area or a neighbour.
void simplifyLoop(std::vector<int>& loops, std::size_t begin)
{
  bool changed = true;
  while (changed)
  {
    changed = false;
    const std::size_t size = loops.size() - begin;
    for (std::size_t i = 0; i < size && size > 1; ++i)
    {
      const int before = loops[begin + i];
      const std::size_t here = (i + 1) % size;
      const int after = loops[begin + (i + 2) % size];
      if (loops[begin + here] == before || (size > 2 && after == before))
      {
        loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(begin + here));
        changed = true;
        break;
      }
    }
  }
}
}

void CutPoints::reset(const std::array<std::int64_t, 4>& vertices, unsigned corners)
{
  candidates_.clear();
  candidateBits_ = 0;
  points_.clear();
  coordinates_.clear();
  named_.clear();
  corners_ = corners;
  order_ = { 0, 1, 2, 3 };
  reversed_ = false;
  for (int end = 3; end > 0; --end)
  {
    for (int i = 0; i < end; ++i)
    {
      if (vertices[order_[i]] > vertices[order_[i + 1]])
      {
        std::swap(order_[i], order_[i + 1]);
        reversed_ = !reversed_;
      }
    }
  }
  ties_.reset({ vertices[order_[0]], vertices[order_[1]], vertices[order_[2]], vertices[order_[3]] });
}

void CutPoints::setFunctions(const CornerValues* functions, int count)
{
  std::uint64_t all = 0;
  for (int i = 0; i < count; ++i)
  {
    assert(i == 0 || functions[i].function > functions[i - 1].function);
    ties_.add(functions[i].function, sorted(functions[i].values));
    all |= std::uint64_t{ 1 } << functions[i].function;
  }
  candidateBits_ = all;
  for (int i = 0; i < count; ++i)
  {
    const int function = functions[i].function;
    bool beaten = false;
    for (std::uint64_t rest = candidateBits_ & ~(std::uint64_t{ 1 } << function); rest && !beaten; rest &= rest - 1)
    {
      beaten = ties_.dominates(__builtin_ctzll(rest), function, corners_);
    }
    if (beaten)
    {
      candidateBits_ &= ~(std::uint64_t{ 1 } << function);
    }
  }
  for (std::uint64_t rest = candidateBits_; rest != 0; rest &= rest - 1)
  {
    candidates_.push_back(__builtin_ctzll(rest));
  }
}

void CutPoints::setPlane(const std::array<double, 4>& values)
{
  ties_.setPlane(sorted(values));
}

void CutPoints::signs(
  const std::vector<SymbolicVertex>& vertices, int function, int other, std::vector<int>& result) const
{
  result.clear();
  for (const SymbolicVertex& vertex : vertices)
  {
    result.push_back(ties_.sign(vertex.corners, vertex.others | std::uint64_t{ 1 } << function, other));
  }
}

int CutPoints::pointOf(const SymbolicVertex& vertex, int function)
{
  // No function takes part in a corner or in the point where the plane meets an edge.
  const std::uint64_t own = std::uint64_t{ 1 } << function;
  const std::uint64_t tied = vertex.others == 0 ? 0 : vertex.others | own;
  for (const NamedPoint& known : named_)
  {
    if (known.corners == vertex.corners && known.tied == tied)
    {
      return known.point;
    }
  }
  std::array<double, 4> coordinates;
  const CutPoint point = ties_.point(vertex.corners, vertex.others | own, candidateBits_, coordinates);
  const auto same = std::find_if(points_.begin(), points_.end(), [&](const CutPoint& p) { return p.key == point.key; });
  const int found = static_cast<int>(same - points_.begin());
  if (same == points_.end())
  {
    points_.push_back(point);
    coordinates_.push_back(coordinates);
  }
  named_.push_back({ vertex.corners, tied, found });
  return found;
}

bool CutPoints::appendLoop(const std::vector<int>& loop, std::vector<int>& loops) const
{
  const std::size_t begin = loops.size();
  loops.insert(loops.end(), loop.begin(), loop.end());
  simplifyLoop(loops, begin);
  if (loops.size() < begin + 3)
  {
    loops.resize(begin);
    return false;
  }
  if (reversed_)
  {
    std::reverse(loops.begin() + static_cast<std::ptrdiff_t>(begin), loops.end());
  }
  return true;
}
}
