#pragma once

#include "Geometry/Box.h"
#include "Model/Grid.h"
#include "Model/NativeCell.h"
#include "Model/Progress.h"

#include <vector>

namespace strata
{
/// The visible cells of an unstructured grid, over which point data are functions of the place: linear on tetrahedra,
/// isoparametric on hexahedra, wedges and pyramids. The latter two are hexahedra some of whose corners coincide,
/// which gives the usual functions.
class PointCells
{
public:
  /// A point's weights in the corners of a cell, those of a NativeCell; they sum to 1.
  using Weights = std::array<double, 8>;

  PointCells() = default;
  /// Cost: n log n.
  PointCells(const UnstructuredGrid& grid, Progress& progress);

  Index size() const { return static_cast<Index>(cells_.size()); }
  int cornerCount(Index cell) const { return cells_[at(cell)].shape == CellShape::Tetrahedron ? 4 : 8; }
  std::uint32_t corner(Index cell, int i) const { return cells_[at(cell)].corners[at(i)]; }
  Box box(const std::vector<Vector>& points, Index cell) const;
  /// The kind, the corner points as samples, and their places. Throws InvalidInput for a polyhedron, whose data are no
  /// function of a known kind.
  NativeCell nativeCell(const std::vector<Vector>& points, Index cell) const;

  /// A cell that holds a point, with its weights there; -1 if none does. On a common face, of which cells is a function
  /// of the grid and the point alone. Polyhedra hold nothing.
  Index cellAt(const std::vector<Vector>& points, const Vector& p, Weights& weights) const;

private:
  struct Cell
  {
    CellShape shape;
    Index gridCell;
    std::array<std::uint32_t, 8> corners;
  };
  /// A box round the cells order_[begin] .. order_[end - 1]; `second` is the second child, the first one follows the
  /// node itself. 0 in a leaf.
  struct Node
  {
    Box box;
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t second;
  };

  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  void build(const std::vector<Box>& boxes, std::uint32_t begin, std::uint32_t end, Progress& progress);
  bool holds(const std::vector<Vector>& points, Index cell, const Vector& p, Weights& weights) const;

  std::vector<Cell> cells_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  double tolerance_ = 0.0; ///< how far outside of its box a cell may hold a point
};
}
