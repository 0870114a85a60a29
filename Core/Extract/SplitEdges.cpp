#include "Extract/SplitEdges.h"

#include "Extract/ForEach.h"
#include "Extract/PointTree.h"

#include <algorithm>

namespace strata
{
namespace
{
template<typename T>
void sortUnique(std::vector<T>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The points strictly within an edge, in order.
std::vector<Index> pointsWithin(
  const SplitEdges::Edge& edge, const GridTopology& topology, const PointTree& tree, const std::vector<Index>& points)
{
  const Vector origin = topology.point(edge.first);
  const Vector along = topology.point(edge.second) - origin;
  const double tolerance = hangingTolerance * along.norm();
  Box box;
  box.add(origin);
  box.add(Vector(origin + along));
  box.lower.array() -= tolerance;
  box.upper.array() += tolerance;
  std::vector<std::pair<double, Index>> found;
  tree.forEachIn(box, [&](std::size_t i) {
    const Vector d = topology.point(points[i]) - origin;
    const double at = d.dot(along) / along.squaredNorm();
    if (at > hangingTolerance && at < 1.0 - hangingTolerance && (d - at * along).norm() <= tolerance)
    {
      found.emplace_back(at, points[i]);
    }
  });
  std::sort(found.begin(), found.end());
  std::vector<Index> result;
  for (const auto& [at, point] : found)
  {
    result.push_back(point);
  }
  return result;
}
}

SplitEdges::SplitEdges(const GridTopology& topology, const std::vector<UnmatchedFace>& faces, Progress& progress)
{
  std::vector<Index> ids;
  CellFaces cellFaces;
  for (const UnmatchedFace& face : faces)
  {
    progress.check();
    topology.faceCorners(face.cell, cellFaces);
    const std::int32_t first = cellFaces.start[face.face];
    const std::int32_t last = cellFaces.start[face.face + 1];
    for (std::int32_t i = first; i < last; ++i)
    {
      const Index a = cellFaces.corners[i];
      const Index b = cellFaces.corners[i + 1 < last ? i + 1 : first];
      ids.push_back(a);
      edges_.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  sortUnique(ids);
  sortUnique(edges_);
  std::vector<Vector> positions;
  for (Index id : ids)
  {
    positions.push_back(topology.point(id));
  }
  const PointTree tree(std::move(positions));
  points_.resize(edges_.size());
  forEach(edges_.size(), progress, [&](std::size_t e) { points_[e] = pointsWithin(edges_[e], topology, tree, ids); });
  std::size_t kept = 0;
  for (std::size_t e = 0; e < edges_.size(); ++e)
  {
    if (!points_[e].empty())
    {
      edges_[kept] = edges_[e];
      std::swap(points_[kept++], points_[e]);
    }
  }
  edges_.resize(kept);
  points_.resize(kept);
}

const std::vector<Index>* SplitEdges::pointsOf(Index a, Index b) const
{
  const Edge edge{ std::min(a, b), std::max(a, b) };
  const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge);
  return found != edges_.end() && *found == edge ? &points_[static_cast<std::size_t>(found - edges_.begin())] : nullptr;
}

std::vector<Index> SplitEdges::withHangingPoints(const std::vector<Index>& corners) const
{
  std::vector<Index> result;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Index a = corners[i];
    const Index b = corners[(i + 1) % corners.size()];
    result.push_back(a);
    const std::vector<Index>* points = pointsOf(a, b);
    if (points && a < b)
    {
      result.insert(result.end(), points->begin(), points->end());
    }
    else if (points)
    {
      result.insert(result.end(), points->rbegin(), points->rend());
    }
  }
  return result;
}
}
