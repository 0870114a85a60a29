#include "Native/SampleTree.h"

#include "Geometry/Box.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cassert>

namespace strata
{
namespace
{
/// Nodes with more samples are split.
constexpr std::size_t leafSize = 12;
/// Nodes with more samples build their children as two tasks.
constexpr std::size_t taskSize = 8192;
}

void Neighbors::add(const Neighbor& neighbor)
{
  assert(wanted <= capacity);
  if (full() && !(neighbor < farthest()))
  {
    return;
  }
  count += full() ? 0 : 1;
  auto place = static_cast<std::size_t>(count) - 1;
  while (place > 0 && neighbor < found[place - 1])
  {
    found[place] = found[place - 1];
    --place;
  }
  found[place] = neighbor;
}

SampleTree::SampleTree(const std::vector<Vector>& points, std::vector<std::uint32_t> samples, Progress& progress) :
  samples_(std::move(samples))
{
  // Halving by rounding down first, the upper children are the largest: their sizes tell the depth.
  std::size_t nodeCount = 0;
  std::size_t width = 1;
  for (std::size_t size = samples_.size(); size > leafSize; size -= size / 2)
  {
    nodeCount += width;
    width *= 2;
  }
  nodes_.resize(nodeCount);
  build(points, { 0, 0, samples_.size() }, progress);
}

void SampleTree::build(const std::vector<Vector>& points, const Part& part, Progress& progress)
{
  if (part.end - part.begin <= leafSize)
  {
    return;
  }
  Box box;
  for (std::size_t i = part.begin; i < part.end; ++i)
  {
    box.add(points[samples_[i]]);
  }
  int axis = 0;
  box.size().maxCoeff(&axis);
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const double x = points[a][axis];
    const double y = points[b][axis];
    return x != y ? x < y : a < b;
  };
  const auto at = [&](std::size_t i) { return samples_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(part.begin), at(part.middle()), at(part.end), less);
  nodes_[part.node] = { points[samples_[part.middle()]][axis], axis };
  if (part.end - part.begin > taskSize)
  {
    progress.check();
    tbb::parallel_invoke(
      [&] { build(points, part.lower(), progress); }, [&] { build(points, part.upper(), progress); });
  }
  else
  {
    build(points, part.lower(), progress);
    build(points, part.upper(), progress);
  }
}

void SampleTree::nearest(const std::vector<Vector>& points, const Vector& point, Neighbors& neighbors) const
{
  search(points, point, { 0, 0, samples_.size() }, neighbors);
}

void SampleTree::search(
  const std::vector<Vector>& points, const Vector& point, const Part& part, Neighbors& neighbors) const
{
  if (part.end - part.begin <= leafSize)
  {
    for (std::size_t i = part.begin; i < part.end; ++i)
    {
      neighbors.add({ (points[samples_[i]] - point).squaredNorm(), samples_[i] });
    }
    return;
  }
  const Node& node = nodes_[part.node];
  const double offset = point[node.axis] - node.split;
  search(points, point, offset < 0.0 ? part.lower() : part.upper(), neighbors);
  if (!neighbors.full() || offset * offset <= neighbors.farthest().squaredDistance)
  {
    search(points, point, offset < 0.0 ? part.upper() : part.lower(), neighbors);
  }
}
}
