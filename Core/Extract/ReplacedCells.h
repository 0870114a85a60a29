#pragma once

#include "Extract/GridTopology.h"

#include <algorithm>
#include <unordered_map>

namespace strata
{
/// The cells of an unstructured grid that are other polyhedra than the grid lists: those with repeated corners, and
/// those with points of finer cells on their faces.
class ReplacedCells
{
public:
  struct Cell
  {
    std::vector<Index> centerCorners; ///< the corners whose mean is the centre, ascending
    CellFaces faces;                  ///< all neighbours -1
    std::vector<Index> points;        ///< all points of the faces, ascending
  };

  const Cell* find(Index cell) const
  {
    if (cells_.empty())
    {
      return nullptr;
    }
    const auto found = cells_.find(cell);
    return found == cells_.end() ? nullptr : &found->second;
  }

  void set(Index cell, std::vector<Index> centerCorners, CellFaces faces)
  {
    Cell& entry = cells_[cell];
    entry.points = faces.corners;
    sortUnique(entry.points);
    sortUnique(centerCorners);
    entry.centerCorners = std::move(centerCorners);
    entry.faces = std::move(faces);
  }

private:
  static void sortUnique(std::vector<Index>& ids)
  {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }

  std::unordered_map<Index, Cell> cells_;
};
}
