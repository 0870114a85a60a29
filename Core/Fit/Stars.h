#pragma once

#include "Model/Hierarchy.h"

#include <vector>

namespace strata
{
/// The cells round each vertex of cells with large errors, and groups of vertices no two of which share a cell.
class Stars
{
public:
  /// Takes the vertices of those `cells` whose entry in `errors` is not below the threshold.
  Stars(const Hierarchy& values, const std::vector<CellId>& cells, const std::vector<double>& errors, double threshold);

  const std::vector<std::vector<std::size_t>>& colors() const { return colors_; }
  VertexId vertex(std::size_t i) const { return vertices_[i]; }
  /// Positions in the list of cells.
  const std::vector<std::size_t>& cellsAt(std::size_t i) const { return cellsAt_[i]; }

private:
  void findVertices(
    const Hierarchy& values, const std::vector<CellId>& cells, const std::vector<double>& errors, double threshold);
  void findCells(const Hierarchy& values, const std::vector<CellId>& cells);
  void color(const Hierarchy& values, const std::vector<CellId>& cells);

  std::vector<std::int32_t> indexOf_; ///< [hierarchy vertex], -1 if it is not taken
  std::vector<VertexId> vertices_;
  std::vector<std::vector<std::size_t>> cellsAt_;
  std::vector<std::vector<std::size_t>> colors_;
};
}
