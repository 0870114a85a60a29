#include "Geometry/TetrahedronLocator.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace strata
{
namespace
{
/// Width of a cell's skin, in units of the largest coordinate times the machine's epsilon: the rounding of a vertex, of
/// the point and of the products between them.
constexpr double toleranceUnits = 64.0;
/// Below this level of the tree, subtrees are built by one thread.
constexpr int levelsInParallel = 8;

/// The corners other than i.
constexpr std::array<std::array<int, 3>, 4> opposite = { { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } } };
}

TetrahedronLocator::TetrahedronLocator(
  const double* points, const std::int64_t* tetrahedra, std::int64_t cellCount, const std::function<void()>& check) :
  points_(points),
  tetrahedra_(tetrahedra), order_(static_cast<std::size_t>(cellCount))
{
  if (cellCount == 0)
  {
    return;
  }
  while (cellCount >> depth_ > cellsPerLeaf)
  {
    ++depth_;
  }
  std::iota(order_.begin(), order_.end(), std::int64_t{ 0 });
  std::vector<Vector> centers(order_.size());
  tbb::parallel_for(std::int64_t{ 0 }, cellCount, [&](std::int64_t cell) {
    centers[cell] = 0.25 * (corner(cell, 0) + corner(cell, 1) + corner(cell, 2) + corner(cell, 3));
  });
  boxes_.resize((std::size_t{ 2 } << depth_) - 1);
  build(0, 0, centers, check);
  const double largest = std::max(bounds().lower.cwiseAbs().maxCoeff(), bounds().upper.cwiseAbs().maxCoeff());
  tolerance_ = toleranceUnits * std::numeric_limits<double>::epsilon() * largest;
}

void TetrahedronLocator::build(
  std::int64_t node, int depth, const std::vector<Vector>& centers, const std::function<void()>& check)
{
  const std::int64_t leaf = (node - ((std::int64_t{ 1 } << depth) - 1)) << (depth_ - depth);
  if (depth == depth_)
  {
    boundLeaf(node, leaf);
    return;
  }
  check();
  const auto begin = order_.begin() + leafStart(leaf);
  const auto end = order_.begin() + leafStart(leaf + (std::int64_t{ 1 } << (depth_ - depth)));
  const auto middle = order_.begin() + leafStart(leaf + (std::int64_t{ 1 } << (depth_ - depth - 1)));
  Box box;
  std::for_each(begin, end, [&](std::int64_t cell) { box.add(centers[cell]); });
  int axis = 0;
  box.size().maxCoeff(&axis);
  std::nth_element(begin, middle, end, [&](std::int64_t a, std::int64_t b) {
    const double x = centers[a][axis];
    const double y = centers[b][axis];
    return x < y || (x == y && a < b);
  });
  const auto left = [&] { build(2 * node + 1, depth + 1, centers, check); };
  const auto right = [&] { build(2 * node + 2, depth + 1, centers, check); };
  if (depth < levelsInParallel)
  {
    tbb::parallel_invoke(left, right);
  }
  else
  {
    left();
    right();
  }
  boxes_[node] = boxes_[2 * node + 1];
  boxes_[node].add(boxes_[2 * node + 2]);
}

void TetrahedronLocator::boundLeaf(std::int64_t node, std::int64_t leaf)
{
  for (std::int64_t i = leafStart(leaf); i < leafStart(leaf + 1); ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      boxes_[node].add(corner(order_[i], j));
    }
  }
}

bool TetrahedronLocator::holds(std::int64_t cell, const Vector& p, Weights& weights) const
{
  const std::array<Vector, 4> x = { corner(cell, 0) - p, corner(cell, 1) - p, corner(cell, 2) - p,
    corner(cell, 3) - p };
  double total = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const auto& [a, b, c] = opposite[i];
    weights[i] = (i % 2 == 0 ? 1.0 : -1.0) * x[a].dot(x[b].cross(x[c]));
    total += weights[i];
  }
  if (!(std::abs(total) > 0.0))
  {
    return false;
  }
  for (int i = 0; i < 4; ++i)
  {
    // Six times the volume over this corner's face; negative where the point lies beyond the face.
    const double height = total > 0.0 ? weights[i] : -weights[i];
    if (height < 0.0)
    {
      const auto& [a, b, c] = opposite[i];
      if (-height > tolerance_ * (x[b] - x[a]).cross(x[c] - x[a]).norm())
      {
        return false;
      }
    }
  }
  for (double& weight : weights)
  {
    weight /= total;
  }
  return true;
}

std::int64_t TetrahedronLocator::anyCell(const Vector& p, Weights& weights) const
{
  std::int64_t found = -1;
  visitCells(p, [&](std::int64_t cell, const Weights& w) {
    found = cell;
    weights = w;
    return true;
  });
  return found;
}
}
