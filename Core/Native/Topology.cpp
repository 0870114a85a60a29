#include "Native/Topology.h"

#include <algorithm>

namespace strata
{
Topology::Topology(const Grid& grid, bool cellsRoundPoints) :
  rectilinear_(std::get_if<RectilinearGrid>(&grid)), unstructured_(std::get_if<UnstructuredGrid>(&grid)),
  hidden_(rectilinear_ ? &rectilinear_->hidden : &unstructured_->hidden)
{
  if (unstructured_ && cellsRoundPoints)
  {
    listCells();
  }
}

void Topology::listCells()
{
  const UnstructuredGrid& grid = *unstructured_;
  cellOffsets_.assign(grid.points.size() + 1, 0);
  for (const Index point : grid.corners)
  {
    ++cellOffsets_[static_cast<std::size_t>(point) + 1];
  }
  for (std::size_t p = 0; p < grid.points.size(); ++p)
  {
    cellOffsets_[p + 1] += cellOffsets_[p];
  }
  cells_.resize(grid.corners.size());
  std::vector<Index> next(cellOffsets_.begin(), cellOffsets_.end() - 1);
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    for (Index c = grid.cornerOffsets[static_cast<std::size_t>(cell)];
         c < grid.cornerOffsets[static_cast<std::size_t>(cell) + 1]; ++c)
    {
      const Index point = grid.corners[static_cast<std::size_t>(c)];
      cells_[static_cast<std::size_t>(next[static_cast<std::size_t>(point)]++)] = cell;
    }
  }
}

void Topology::corners(Index cell, std::vector<Index>& corners) const
{
  corners.clear();
  if (unstructured_)
  {
    const auto& offsets = unstructured_->cornerOffsets;
    const Index* all = unstructured_->corners.data();
    corners.assign(all + offsets[static_cast<std::size_t>(cell)], all + offsets[static_cast<std::size_t>(cell) + 1]);
    return;
  }
  const Index cx = rectilinear_->cellCount(0);
  const Index cy = rectilinear_->cellCount(1);
  const Index nx = rectilinear_->pointCount(0);
  const Index ny = rectilinear_->pointCount(1);
  const Index first = cell % cx + nx * ((cell / cx) % cy + ny * (cell / (cx * cy)));
  for (const Index offset : { Index{ 0 }, Index{ 1 }, nx, nx + 1 })
  {
    corners.push_back(first + offset);
    corners.push_back(first + offset + nx * ny);
  }
}

void Topology::visibleCells(Index point, std::vector<Index>& cells) const
{
  cells.clear();
  const auto add = [&](Index cell) {
    if (!hidden(cell))
    {
      cells.push_back(cell);
    }
  };
  if (unstructured_)
  {
    std::for_each(cells_.begin() + cellOffsets_[static_cast<std::size_t>(point)],
      cells_.begin() + cellOffsets_[static_cast<std::size_t>(point) + 1], add);
    return;
  }
  const RectilinearGrid& grid = *rectilinear_;
  const Index i = point % grid.pointCount(0);
  const Index j = (point / grid.pointCount(0)) % grid.pointCount(1);
  const Index k = point / (grid.pointCount(0) * grid.pointCount(1));
  for (Index z = std::max<Index>(k - 1, 0); z <= std::min(k, grid.cellCount(2) - 1); ++z)
  {
    for (Index y = std::max<Index>(j - 1, 0); y <= std::min(j, grid.cellCount(1) - 1); ++y)
    {
      for (Index x = std::max<Index>(i - 1, 0); x <= std::min(i, grid.cellCount(0) - 1); ++x)
      {
        add(x + grid.cellCount(0) * (y + grid.cellCount(1) * z));
      }
    }
  }
}
}
