#pragma once

#include "Geometry/Box.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace strata
{
/// Finds the tetrahedra of a mesh that hold a point: a balanced tree of boxes over the cells.
///
/// Cells are closed and a rounding error wide, so a point on a shared face, edge or vertex is found in each of the
/// cells round it, and no point of the mesh falls between two cells. Orientation doesn't matter; cells without a
/// volume hold nothing. Building costs O(n log n), a query about a microsecond. Queries are thread-safe.
class TetrahedronLocator
{
public:
  /// A point's weights in a tetrahedron's corners; they sum to 1 and may be negative by rounding.
  using Weights = std::array<double, 4>;

  /// A view of `cellCount` tetrahedra (4 vertices each; 3 coordinates per vertex) that must outlive the locator.
  /// `check` is called now and then while the tree is built, from any thread, and may throw to stop.
  TetrahedronLocator(
    const double* points, const std::int64_t* tetrahedra, std::int64_t cellCount,
    const std::function<void()>& check = [] {});

  /// Calls visit(cell, weights) -> bool for each cell that holds the point, in an order that depends on the mesh and
  /// the point alone, until it returns true. Tells whether it did.
  template<class Visit>
  bool visitCells(const Vector& p, Visit&& visit) const;

  /// The first cell found that holds the point, or -1.
  std::int64_t anyCell(const Vector& p, Weights& weights) const;

  /// Whether a cell holds the point, and the point's weights there.
  bool holds(std::int64_t cell, const Vector& p, Weights& weights) const;

  /// The box round all cells.
  Box bounds() const { return boxes_.empty() ? Box() : boxes_.front(); }
  /// How far outside a cell a point may lie to be counted in, in the data's length unit.
  double tolerance() const { return tolerance_; }

private:
  template<class Visit>
  bool visitLeaf(std::int64_t leaf, const Vector& p, Visit& visit) const;

  static constexpr int deepestTree = 48;
  static constexpr std::int64_t cellsPerLeaf = 4;

  Vector corner(std::int64_t cell, int i) const
  {
    const double* p = points_ + 3 * tetrahedra_[4 * cell + i];
    return { p[0], p[1], p[2] };
  }
  /// Leaf k has the cells order_[leafStart(k)] .. order_[leafStart(k + 1)].
  std::int64_t leafStart(std::int64_t leaf) const { return static_cast<std::int64_t>(order_.size()) * leaf >> depth_; }
  void build(std::int64_t node, int depth, const std::vector<Vector>& centers, const std::function<void()>& check);
  void boundLeaf(std::int64_t node, std::int64_t leaf);

  const double* points_;
  const std::int64_t* tetrahedra_;
  double tolerance_ = 0.0;
  int depth_ = 0;
  /// A complete binary tree: the children of node i are 2 i + 1 and 2 i + 2; the last level are the leaves.
  std::vector<Box> boxes_;
  std::vector<std::int64_t> order_;
};

template<class Visit>
bool TetrahedronLocator::visitCells(const Vector& p, Visit&& visit) const
{
  const double reach = tolerance_ * tolerance_;
  if (boxes_.empty())
  {
    return false;
  }
  const std::int64_t firstLeaf = (std::int64_t{ 1 } << depth_) - 1;
  std::array<std::int64_t, deepestTree> stack;
  int size = 0;
  const auto push = [&](std::int64_t node) {
    if (boxes_[node].squaredDistance(p) <= reach)
    {
      stack[size++] = node;
    }
  };
  push(0);
  while (size > 0)
  {
    const std::int64_t node = stack[--size];
    if (node < firstLeaf)
    {
      push(2 * node + 2);
      push(2 * node + 1);
    }
    else if (visitLeaf(node - firstLeaf, p, visit))
    {
      return true;
    }
  }
  return false;
}

template<class Visit>
bool TetrahedronLocator::visitLeaf(std::int64_t leaf, const Vector& p, Visit& visit) const
{
  Weights weights;
  for (std::int64_t i = leafStart(leaf); i < leafStart(leaf + 1); ++i)
  {
    if (holds(order_[i], p, weights) && visit(order_[i], weights))
    {
      return true;
    }
  }
  return false;
}
}
