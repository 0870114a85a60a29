#include "Geometry/TriangleTree.h"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <numeric>

namespace strata
{
namespace
{
constexpr std::int32_t trianglesPerTask = 4096;
constexpr int deepestStack = 64;
constexpr std::int32_t fullNode = 4;

/// How many of some triangles come first where they are split, so that most nodes are full; all where they are not.
std::int32_t firstHalf(std::int32_t triangles)
{
  return triangles <= fullNode ? triangles : (triangles / 2 + fullNode - 1) / fullNode * fullNode;
}

/// Nodes of the tree over so many triangles: its shape follows from their number alone.
std::int32_t nodeCount(std::int32_t triangles)
{
  if (triangles <= fullNode)
  {
    return 1;
  }
  std::int32_t count = 1;
  const std::int32_t first = firstHalf(triangles);
  for (const std::int32_t half : { first, triangles - first })
  {
    for (const std::int32_t quarter : { firstHalf(half), half - firstHalf(half) })
    {
      count += quarter > 0 ? nodeCount(quarter) : 0;
    }
  }
  return count;
}

struct Candidate
{
  std::int32_t child;
  double squaredDistance;
};
}

void TriangleTree::Node::add(std::int32_t newChild, const Box& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis][count] = box.lower[axis];
    upper[axis][count] = box.upper[axis];
  }
  child[count++] = newChild;
}

Eigen::Array4d TriangleTree::Node::squaredDistances(const Vector& p) const
{
  Eigen::Array4d sums = Eigen::Array4d::Zero();
  for (int axis = 0; axis < 3; ++axis)
  {
    sums += (lower[axis] - p[axis]).max(p[axis] - upper[axis]).max(0.0).square();
  }
  return sums;
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
    build(0, { 0, count }, centers);
  }
}

std::array<TriangleTree::Range, 2> TriangleTree::halves(Range range, const std::vector<Vector>& centers)
{
  const std::int32_t middle = range.begin + firstHalf(range.count());
  if (middle < range.end)
  {
    Box box;
    std::for_each(
      order_.begin() + range.begin, order_.begin() + range.end, [&](std::int32_t t) { box.add(centers[t]); });
    int axis = 0;
    box.size().maxCoeff(&axis);
    std::nth_element(order_.begin() + range.begin, order_.begin() + middle, order_.begin() + range.end,
      [&](std::int32_t a, std::int32_t b) {
        const double x = centers[a][axis];
        const double y = centers[b][axis];
        return x < y || (x == y && a < b);
      });
  }
  return { Range{ range.begin, middle }, Range{ middle, range.end } };
}

Box TriangleTree::buildLeaf(Node& node, Range range)
{
  Box all;
  for (std::int32_t i = range.begin; i < range.end; ++i)
  {
    Box box;
    std::for_each(triangles_[order_[i]].begin(), triangles_[order_[i]].end(), [&](const Vector& p) { box.add(p); });
    node.add(~order_[i], box);
    all.add(box);
  }
  return all;
}

Box TriangleTree::build(std::int32_t id, Range range, const std::vector<Vector>& centers)
{
  if (range.count() <= fullNode)
  {
    return buildLeaf(nodes_[id], range);
  }
  struct Part
  {
    Range range;
    std::int32_t id = 0;
    Box box;
  };
  std::vector<Part> parts;
  std::int32_t next = id + 1;
  for (const Range half : halves(range, centers))
  {
    for (const Range quarter : halves(half, centers))
    {
      if (quarter.count() > 0)
      {
        parts.push_back({ quarter, next, {} });
        next += nodeCount(quarter.count());
      }
    }
  }
  const auto buildPart = [&](Part& part) { part.box = build(part.id, part.range, centers); };
  if (range.count() > trianglesPerTask)
  {
    tbb::parallel_for_each(parts.begin(), parts.end(), buildPart);
  }
  else
  {
    std::for_each(parts.begin(), parts.end(), buildPart);
  }
  Box all;
  for (const Part& part : parts)
  {
    nodes_[id].add(part.id, part.box);
    all.add(part.box);
  }
  return all;
}

void TriangleTree::test(std::int32_t triangle, const Vector& p, Hit& best) const
{
  const ClosestPoint candidate = closestPointOnTriangle(p, triangles_[triangle]);
  const double d2 = (candidate.point - p).squaredNorm();
  const bool firstOfEqual = d2 == best.squaredDistance && (best.triangle < 0 || triangle < best.triangle);
  if (d2 < best.squaredDistance || firstOfEqual)
  {
    best = { triangle, candidate.point, candidate.feature, d2 };
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
  std::array<Candidate, deepestStack> stack;
  int depth = 0;
  stack[depth++] = { 0, 0.0 };
  while (depth > 0)
  {
    const Candidate next = stack[--depth];
    if (next.squaredDistance > best.squaredDistance)
    {
      continue;
    }
    if (next.child < 0)
    {
      test(~next.child, p, best);
      continue;
    }
    const Node& node = nodes_[next.child];
    const Eigen::Array4d distances = node.squaredDistances(p);
    // The closest comes to the top.
    const int first = depth;
    for (std::int32_t k = 0; k < node.count; ++k)
    {
      if (distances[k] <= best.squaredDistance)
      {
        int place = depth++;
        for (; place > first && stack[place - 1].squaredDistance < distances[k]; --place)
        {
          stack[place] = stack[place - 1];
        }
        stack[place] = { node.child[k], distances[k] };
      }
    }
  }
  return best;
}
}
