#include "Geometry/CutTetrahedron.h"

#include <algorithm>
#include <cassert>

namespace strata
{
namespace
{
/// Removes repeated points and spikes (p q p), so that every edge that is left bounds an area or a neighbour.
void simplifyLoop(std::vector<int>& loops, int begin)
{
  bool changed = true;
  while (changed)
  {
    changed = false;
    const int size = static_cast<int>(loops.size()) - begin;
    for (int i = 0; i < size && size > 1; ++i)
    {
      const int before = loops[begin + i];
      const int here = (i + 1) % size;
      const int after = loops[begin + (i + 2) % size];
      if (loops[begin + here] == before || (size > 2 && after == before))
      {
        loops.erase(loops.begin() + begin + here);
        changed = true;
        break;
      }
    }
  }
}
}

void TetrahedronCut::cut(const std::array<std::int64_t, 4>& vertices, const CornerValues* functions, int count)
{
  winners_.clear();
  faces_.clear();
  loops_.clear();
  points_.clear();
  coordinates_.clear();
  named_.clear();
  sortCorners(vertices);
  addFunctions(functions, count);
  for (int function : candidates_)
  {
    addRegion(function);
  }
}

void TetrahedronCut::sortCorners(const std::array<std::int64_t, 4>& vertices)
{
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

void TetrahedronCut::addFunctions(const CornerValues* functions, int count)
{
  candidates_.clear();
  for (int i = 0; i < count; ++i)
  {
    const std::array<double, 4>& values = functions[i].values;
    assert(i == 0 || functions[i].function > functions[i - 1].function);
    ties_.add(functions[i].function, { values[order_[0]], values[order_[1]], values[order_[2]], values[order_[3]] });
    candidates_.push_back(functions[i].function);
  }
  // What another function beats at every corner wins nowhere.
  const auto beaten = [this](int function) {
    return std::any_of(candidates_.begin(), candidates_.end(),
      [&](int other) { return other != function && ties_.dominates(other, function, 15u); });
  };
  std::vector<int>& kept = winners_;
  std::copy_if(candidates_.begin(), candidates_.end(), std::back_inserter(kept), [&](int f) { return !beaten(f); });
  candidates_.swap(kept);
  winners_.clear();
}

void TetrahedronCut::addRegion(int function)
{
  region_.reset();
  for (int other : candidates_)
  {
    if (other == function || region_.empty())
    {
      continue;
    }
    signs_.clear();
    for (const SymbolicVertex& vertex : region_.vertices())
    {
      const std::uint64_t tied = vertex.others | std::uint64_t{ 1 } << function;
      signs_.push_back(ties_.sign(vertex.corners, tied, other));
    }
    region_.clip(other, signs_);
  }
  if (region_.empty())
  {
    return;
  }
  pointOfVertex_.clear();
  for (const SymbolicVertex& vertex : region_.vertices())
  {
    pointOfVertex_.push_back(pointOf(vertex, function));
  }
  const std::size_t before = faces_.size();
  for (const SymbolicPolyhedron::Face& face : region_.faces())
  {
    addFace(function, face);
  }
  if (faces_.size() > before)
  {
    winners_.push_back(function);
  }
}

void TetrahedronCut::addFace(int function, const SymbolicPolyhedron::Face& face)
{
  const int begin = static_cast<int>(loops_.size());
  for (int i = face.begin; i < face.end; ++i)
  {
    loops_.push_back(pointOfVertex_[region_.loops()[i]]);
  }
  simplifyLoop(loops_, begin);
  if (loops_.size() < static_cast<std::size_t>(begin) + 3)
  {
    loops_.resize(begin);
    return;
  }
  if (reversed_)
  {
    std::reverse(loops_.begin() + begin, loops_.end());
  }
  const int beyond = face.label < 0 ? -1 - order_[-1 - face.label] : face.label;
  faces_.push_back({ function, beyond, begin, static_cast<int>(loops_.size()) });
}

int TetrahedronCut::pointOf(const SymbolicVertex& vertex, int function)
{
  const bool atCorner = vertex.others == 0;
  const std::uint64_t tied = atCorner ? 0 : vertex.others | std::uint64_t{ 1 } << function;
  for (const NamedPoint& known : named_)
  {
    if (known.corners == vertex.corners && known.tied == tied)
    {
      return known.point;
    }
  }
  std::uint64_t candidates = 0;
  for (int candidate : candidates_)
  {
    candidates |= std::uint64_t{ 1 } << candidate;
  }
  std::array<double, 4> coordinates;
  const CutPoint point =
    ties_.point(vertex.corners, atCorner ? std::uint64_t{ 1 } << function : tied, candidates, coordinates);
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
}
