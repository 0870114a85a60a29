#pragma once

#include "Model/Hierarchy.h"

#include <vector>

namespace strata
{
/// The cells round each of some vertices, and groups of vertices no two of which share a cell.
class Stars
{
public:
  Stars(const Hierarchy& values, const std::vector<CellId>& cells, std::vector<VertexId> vertices);

  const std::vector<std::vector<std::size_t>>& colors() const { return colors_; }
  VertexId vertex(std::size_t i) const { return vertices_[i]; }
  /// Positions in the list of cells.
  const std::vector<std::size_t>& cellsAt(std::size_t i) const { return cellsAt_[i]; }

private:
  void findCells(const Hierarchy& values, const std::vector<CellId>& cells);
  void color(const Hierarchy& values, const std::vector<CellId>& cells);

  std::vector<std::int32_t> indexOf_; ///< [hierarchy vertex], -1 if it is not taken
  std::vector<VertexId> vertices_;
  std::vector<std::vector<std::size_t>> cellsAt_;
  std::vector<std::vector<std::size_t>> colors_;
};
}
