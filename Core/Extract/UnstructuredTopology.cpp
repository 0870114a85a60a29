#include "Extract/GridTopology.h"

#include "Extract/HangingNodes.h"
#include "Extract/NativeFaces.h"
#include "Extract/UnmatchedFaces.h"
#include "Extract/UsableCells.h"

#include <algorithm>

namespace strata
{
namespace
{
class UnstructuredGridTopology final : public GridTopology
{
public:
  UnstructuredGridTopology(const UnstructuredGrid& grid, Progress& progress) : grid_(grid)
  {
    UsableCells usable = findUsableCells(grid, progress);
    hidden_ = std::move(usable.hidden);
    replaced_ = std::move(usable.replaced);
    warnings_ = std::move(usable.warnings);
    indexCellsByPoint(progress);
    const std::vector<UnmatchedFace> unmatched = findUnmatchedFaces(*this, progress);
    if (!unmatched.empty())
    {
      ReplacedCells joined = replaced_;
      joinHangingNodes(*this, unmatched, joined, warnings_, progress);
      replaced_ = std::move(joined);
      indexCellsByPoint(progress);
    }
  }

  Index cellCount() const override { return grid_.cellCount(); }
  Index pointCount() const override { return grid_.pointCount(); }
  bool hidden(Index cell) const override { return !hidden_.empty() && hidden_[static_cast<std::size_t>(cell)] != 0; }
  Vector point(Index point) const override { return grid_.points[static_cast<std::size_t>(point)]; }

  void corners(Index cell, std::vector<Index>& result) const override
  {
    const auto [first, last] = points(cell);
    result.assign(first, last);
  }

  void centerCorners(Index cell, std::vector<Index>& result) const override
  {
    if (const ReplacedCells::Cell* replaced = replaced_.find(cell))
    {
      result = replaced->centerCorners;
      return;
    }
    corners(cell, result);
  }

  void faceCorners(Index cell, CellFaces& result) const override
  {
    if (const ReplacedCells::Cell* replaced = replaced_.find(cell))
    {
      result = replaced->faces;
      return;
    }
    result.clear();
    addNativeFaces(grid_, cell, result);
  }

  void faces(Index cell, CellFaces& result) const override
  {
    faceCorners(cell, result);
    for (std::int32_t f = 0; f < result.count(); ++f)
    {
      result.neighbours[f] =
        neighbour(cell, result.corners.data() + result.start[f], result.start[f + 1] - result.start[f]);
    }
  }

  void cellsAround(Index point, std::vector<Index>& result) const override
  {
    result.assign(cells_.begin() + cellStart_[point], cells_.begin() + cellStart_[point + 1]);
  }

private:
  std::pair<const Index*, const Index*> points(Index cell) const
  {
    if (const ReplacedCells::Cell* replaced = replaced_.find(cell))
    {
      return { replaced->points.data(), replaced->points.data() + replaced->points.size() };
    }
    return { grid_.corners.data() + grid_.cornerOffsets[cell], grid_.corners.data() + grid_.cornerOffsets[cell + 1] };
  }

  void indexCellsByPoint(Progress& progress)
  {
    cellStart_.assign(static_cast<std::size_t>(grid_.pointCount()) + 1, 0);
    const auto forEachCorner = [&](auto&& visit) {
      constexpr Index checkInterval = 65536;
      for (Index cell = 0; cell < grid_.cellCount(); ++cell)
      {
        if (cell % checkInterval == 0)
        {
          progress.check();
        }
        const auto [first, last] = hidden(cell) ? std::pair<const Index*, const Index*>() : points(cell);
        std::for_each(first, last, [&, c = cell](Index point) { visit(c, point); });
      }
    };
    forEachCorner([this](Index, Index point) { ++cellStart_[point + 1]; });
    for (std::size_t i = 1; i < cellStart_.size(); ++i)
    {
      cellStart_[i] += cellStart_[i - 1];
    }
    cells_.resize(static_cast<std::size_t>(cellStart_.back()));
    std::vector<Index> next(cellStart_.begin(), cellStart_.end() - 1);
    forEachCorner([&](Index cell, Index point) { cells_[next[point]++] = cell; });
  }

  bool hasFace(Index cell, const Index* corners, std::size_t count) const
  {
    const ReplacedCells::Cell* replaced = replaced_.find(cell);
    if (!replaced)
    {
      return hasNativeFace(grid_, cell, corners, count);
    }
    const CellFaces& list = replaced->faces;
    for (std::int32_t f = 0; f < list.count(); ++f)
    {
      const Index* first = list.corners.data() + list.start[f];
      const Index* last = list.corners.data() + list.start[f + 1];
      if (static_cast<std::size_t>(last - first) == count && std::is_permutation(first, last, corners))
      {
        return true;
      }
    }
    return false;
  }

  /// The other cell that has a face.
  Index neighbour(Index cell, const Index* corners, std::int32_t count) const
  {
    for (Index i = cellStart_[corners[0]]; i < cellStart_[corners[0] + 1]; ++i)
    {
      if (cells_[i] != cell && hasFace(cells_[i], corners, static_cast<std::size_t>(count)))
      {
        return cells_[i];
      }
    }
    return -1;
  }

  const UnstructuredGrid& grid_;
  ReplacedCells replaced_;
  std::vector<std::uint8_t> hidden_; ///< empty if none is
  /// Visible cells by corner point: cells_[cellStart_[p]] .. cells_[cellStart_[p + 1]], ascending.
  std::vector<Index> cellStart_;
  std::vector<Index> cells_;
};
}

std::unique_ptr<GridTopology> makeGridTopology(const UnstructuredGrid& grid, Progress& progress)
{
  return std::make_unique<UnstructuredGridTopology>(grid, progress);
}
}
