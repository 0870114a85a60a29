#pragma once

#include "Model/Grid.h"

#include <vector>

namespace strata
{
/// Which points are the corners of a cell, and which cells lie round a point, for both kinds of grid.
/// The grid must outlive it. For an unstructured grid the cells round points are listed on construction
/// where `cellsRoundPoints` asks for them: 8 bytes per corner of a cell.
class Topology
{
public:
  Topology(const Grid& grid, bool cellsRoundPoints);

  bool hidden(Index cell) const { return !hidden_->empty() && (*hidden_)[static_cast<std::size_t>(cell)] != 0; }
  /// Replaces `corners` by the cell's corner points.
  void corners(Index cell, std::vector<Index>& corners) const;
  /// Replaces `cells` by the visible cells that have the point as a corner, ascending.
  void visibleCells(Index point, std::vector<Index>& cells) const;

private:
  void listCells();

  const RectilinearGrid* rectilinear_ = nullptr;
  const UnstructuredGrid* unstructured_ = nullptr;
  const std::vector<std::uint8_t>* hidden_ = nullptr;
  std::vector<Index> cellOffsets_;
  std::vector<Index> cells_;
};
}
