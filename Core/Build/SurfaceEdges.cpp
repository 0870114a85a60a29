#include "Build/SurfaceEdges.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace strata
{
namespace
{
/// A point this close to a wall of the box lies on it (relative to the diagonal).
constexpr double wallTolerance = 1e-9;

/// Points that open edges connect.
class Parts
{
public:
  void join(std::int32_t a, std::int32_t b) { parent_[root(a)] = root(b); }
  std::int32_t root(std::int32_t point)
  {
    const auto at = parent_.emplace(point, point).first;
    return at->second == point ? point : at->second = root(at->second);
  }

private:
  std::map<std::int32_t, std::int32_t> parent_;
};

struct Edge
{
  std::int32_t low;
  std::int32_t high;
};

double distanceToWall(const Box& box, const Vector& p)
{
  return std::max(0.0, std::min((p - box.lower).minCoeff(), (box.upper - p).minCoeff()));
}

/// An open part of a surface.
struct Part
{
  double length = 0.0;
  double fromWall = 0.0;
  Box box;
};

OpenBorder describe(
  MaterialId material, const std::vector<Edge>& edges, const std::vector<Vector>& points, const Box& walls)
{
  Parts parts;
  for (const Edge& edge : edges)
  {
    parts.join(edge.low, edge.high);
  }
  std::map<std::int32_t, Part> found;
  OpenBorder border;
  border.material = material;
  border.edges = static_cast<Index>(edges.size());
  for (const Edge& edge : edges)
  {
    Part& part = found[parts.root(edge.low)];
    const double length = (points[edge.high] - points[edge.low]).norm();
    part.length += length;
    border.length += length;
    for (const Vector& point : { points[edge.low], points[edge.high] })
    {
      part.box.add(point);
      part.fromWall = std::max(part.fromWall, distanceToWall(walls, point));
    }
  }
  const Part& longest = std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.second.length < b.second.length;
  })->second;
  border.lower = longest.box.lower;
  border.upper = longest.box.upper;
  border.reach = std::min(0.5 * longest.box.diagonal(), longest.fromWall);
  return border;
}
}

std::vector<SurfaceTriangle> outwardTriangles(const Interfaces& interfaces, MaterialId material)
{
  std::vector<SurfaceTriangle> result;
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    if (surface.negative == material)
    {
      result.insert(result.end(), surface.triangles.begin(), surface.triangles.end());
    }
    else if (surface.positive == material)
    {
      for (const SurfaceTriangle& t : surface.triangles)
      {
        result.push_back({ t[0], t[2], t[1] });
      }
    }
  }
  return result;
}

std::vector<EdgeUse> sortedEdgeUses(const std::vector<SurfaceTriangle>& triangles)
{
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
  {
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      const std::int32_t from = triangles[i][k];
      const std::int32_t to = triangles[i][(k + 1) % 3];
      uses.push_back({ std::min(from, to), std::max(from, to), i, k, from < to });
    }
  }
  tbb::parallel_sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle, a.edge) < std::tie(b.low, b.high, b.triangle, b.edge);
  });
  return uses;
}

bool isClosed(const EdgeUse* begin, const EdgeUse* end)
{
  return 2 * std::count_if(begin, end, [](const EdgeUse& use) { return use.forward; }) == end - begin;
}

bool endsAtWall(const Box& box, std::initializer_list<Vector> points)
{
  const double tolerance = wallTolerance * box.diagonal();
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto beyond = [&](double sign, double wall) {
      return std::all_of(
        points.begin(), points.end(), [&](const Vector& p) { return sign * (p[axis] - wall) >= -tolerance; });
    };
    if (beyond(-1.0, box.lower[axis]) || beyond(1.0, box.upper[axis]))
    {
      return true;
    }
  }
  return false;
}

std::vector<OpenBorder> openBorders(const Interfaces& interfaces, Index materialCount, const Box& box)
{
  std::vector<OpenBorder> result;
  for (Index m = 0; m < materialCount; ++m)
  {
    const std::vector<EdgeUse> uses = sortedEdgeUses(outwardTriangles(interfaces, MaterialId(m)));
    std::vector<Edge> open;
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end)
    {
      while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high)
      {
        ++end;
      }
      const Edge edge{ uses[begin].low, uses[begin].high };
      if (!isClosed(uses.data() + begin, uses.data() + end) &&
          !endsAtWall(box, { interfaces.points[edge.low], interfaces.points[edge.high] }))
      {
        open.push_back(edge);
      }
    }
    if (!open.empty())
    {
      result.push_back(describe(MaterialId(m), open, interfaces.points, box));
    }
  }
  return result;
}
}
