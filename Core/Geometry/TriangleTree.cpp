#include "Geometry/TriangleTree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <numeric>

namespace strata
{
namespace
{
constexpr std::int32_t trianglesPerLeaf = 4;
constexpr std::int32_t trianglesPerTask = 4096;
constexpr int deepestTree = 64;

/// Nodes of the tree over so many triangles: its shape follows from their number alone.
std::int32_t nodeCount(std::int32_t triangles)
{
  return triangles <= trianglesPerLeaf ? 1 : 1 + nodeCount(triangles / 2) + nodeCount(triangles - triangles / 2);
}
}

TriangleTree::TriangleTree(std::vector<std::array<Vector, 3>> triangles) : triangles_(std::move(triangles))
{
  const auto count = static_cast<std::int32_t>(triangles_.size());
  order_.resize(triangles_.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vector> centers(triangles_.size());
  std::transform(triangles_.begin(), triangles_.end(), centers.begin(),
    [](const std::array<Vector, 3>& t) { return Vector((t[0] + t[1] + t[2]) / 3.0); });
  if (count > 0)
  {
    nodes_.resize(static_cast<std::size_t>(nodeCount(count)));
    build(0, 0, count, centers);
  }
}

void TriangleTree::build(std::int32_t id, std::int32_t begin, std::int32_t end, const std::vector<Vector>& centers)
{
  Box box;
  Box centerBox;
  for (std::int32_t i = begin; i < end; ++i)
  {
    for (const Vector& corner : triangles_[order_[i]])
    {
      box.add(corner);
    }
    centerBox.add(centers[order_[i]]);
  }
  const std::int32_t count = end - begin;
  if (count <= trianglesPerLeaf)
  {
    nodes_[id] = { box, 0, begin, count };
    return;
  }
  int axis = 0;
  centerBox.size().maxCoeff(&axis);
  const std::int32_t middle = begin + count / 2;
  std::nth_element(
    order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](std::int32_t a, std::int32_t b) {
      const double x = centers[a][axis];
      const double y = centers[b][axis];
      return x < y || (x == y && a < b);
    });
  const std::int32_t second = id + 1 + nodeCount(count / 2);
  nodes_[id] = { box, second, begin, 0 };
  const auto buildFirst = [&] { build(id + 1, begin, middle, centers); };
  const auto buildSecond = [&] { build(second, middle, end, centers); };
  if (count > trianglesPerTask)
  {
    tbb::parallel_invoke(buildFirst, buildSecond);
    return;
  }
  buildFirst();
  buildSecond();
}

void TriangleTree::searchLeaf(const Node& node, const Vector& p, Hit& best) const
{
  for (std::int32_t i = node.first; i < node.first + node.count; ++i)
  {
    const std::int32_t triangle = order_[i];
    const ClosestPoint candidate = closestPointOnTriangle(p, triangles_[triangle]);
    const double d2 = (candidate.point - p).squaredNorm();
    const bool firstOfEqual = d2 == best.squaredDistance && (best.triangle < 0 || triangle < best.triangle);
    if (d2 < best.squaredDistance || firstOfEqual)
    {
      best = { triangle, candidate.point, candidate.feature, d2 };
    }
  }
}

TriangleTree::Hit TriangleTree::closest(const Vector& p, double maximumSquaredDistance) const
{
  Hit best;
  best.squaredDistance = maximumSquaredDistance;
  if (nodes_.empty())
  {
    return best;
  }
  std::array<std::pair<std::int32_t, double>, deepestTree> stack;
  int depth = 0;
  stack[depth++] = { 0, nodes_[0].box.squaredDistance(p) };
  while (depth > 0)
  {
    const auto [id, distance] = stack[--depth];
    if (distance > best.squaredDistance)
    {
      continue;
    }
    const Node& node = nodes_[id];
    if (node.count > 0)
    {
      searchLeaf(node, p, best);
      continue;
    }
    const std::pair<std::int32_t, double> a = { id + 1, nodes_[id + 1].box.squaredDistance(p) };
    const std::pair<std::int32_t, double> b = { node.second, nodes_[node.second].box.squaredDistance(p) };
    stack[depth++] = a.second <= b.second ? b : a;
    stack[depth++] = a.second <= b.second ? a : b;
  }
  return best;
}
}
