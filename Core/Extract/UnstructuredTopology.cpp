#include "Extract/GridTopology.h"

#include <algorithm>

namespace strata
{
namespace
{
// Faces of the linear cells by VTK's corner numbers, counter-clockwise as seen from outside; -1 ends a triangle.
constexpr int tetrahedronFaces[4][4] = { { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 2, 0, 3, -1 }, { 0, 2, 1, -1 } };
constexpr int hexahedronFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 },
  { 4, 5, 6, 7 } };
constexpr int wedgeFaces[5][4] = { { 0, 1, 2, -1 }, { 3, 5, 4, -1 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } };
constexpr int pyramidFaces[5][4] = { { 0, 3, 2, 1 }, { 0, 1, 4, -1 }, { 1, 2, 4, -1 }, { 2, 3, 4, -1 },
  { 3, 0, 4, -1 } };

class UnstructuredGridTopology final : public GridTopology
{
public:
  explicit UnstructuredGridTopology(const UnstructuredGrid& grid) : grid_(grid) { indexCellsByPoint(); }

  Index cellCount() const override { return grid_.cellCount(); }
  Index pointCount() const override { return grid_.pointCount(); }
  bool hidden(Index cell) const override
  {
    return !grid_.hidden.empty() && grid_.hidden[static_cast<std::size_t>(cell)] != 0;
  }
  Vector point(Index point) const override { return grid_.points[static_cast<std::size_t>(point)]; }

  void corners(Index cell, std::vector<Index>& result) const override
  {
    result.assign(
      grid_.corners.begin() + grid_.cornerOffsets[cell], grid_.corners.begin() + grid_.cornerOffsets[cell + 1]);
  }

  void faces(Index cell, CellFaces& result) const override
  {
    result.clear();
    switch (grid_.shapes[cell])
    {
      case CellShape::Tetrahedron:
        addFaces(cell, tetrahedronFaces, 4, result);
        break;
      case CellShape::Hexahedron:
        addFaces(cell, hexahedronFaces, 6, result);
        break;
      case CellShape::Wedge:
        addFaces(cell, wedgeFaces, 5, result);
        break;
      case CellShape::Pyramid:
        addFaces(cell, pyramidFaces, 5, result);
        break;
      case CellShape::Polyhedron:
        addPolyhedronFaces(cell, result);
        break;
    }
  }

  void cellsAround(Index point, std::vector<Index>& result) const override
  {
    result.assign(cells_.begin() + cellStart_[point], cells_.begin() + cellStart_[point + 1]);
  }

private:
  void indexCellsByPoint()
  {
    cellStart_.assign(static_cast<std::size_t>(grid_.pointCount()) + 1, 0);
    const auto forEachCorner = [this](auto&& visit) {
      for (Index cell = 0; cell < grid_.cellCount(); ++cell)
      {
        for (Index i = grid_.cornerOffsets[cell]; i < grid_.cornerOffsets[cell + 1] && !hidden(cell); ++i)
        {
          visit(cell, grid_.corners[i]);
        }
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

  void addFaces(Index cell, const int (*table)[4], int count, CellFaces& result) const
  {
    const Index* corner = grid_.corners.data() + grid_.cornerOffsets[cell];
    for (int f = 0; f < count; ++f)
    {
      for (int i = 0; i < 4 && table[f][i] >= 0; ++i)
      {
        result.corners.push_back(corner[table[f][i]]);
      }
      endFace(cell, result);
    }
  }

  void addPolyhedronFaces(Index cell, CellFaces& result) const
  {
    for (Index f = grid_.faceOffsets[cell]; f < grid_.faceOffsets[cell + 1]; ++f)
    {
      result.corners.insert(result.corners.end(), grid_.faceCorners.begin() + grid_.faceStart[f],
        grid_.faceCorners.begin() + grid_.faceStart[f + 1]);
      endFace(cell, result);
    }
  }

  void endFace(Index cell, CellFaces& result) const
  {
    const std::size_t first = static_cast<std::size_t>(result.start.back());
    result.neighbours.push_back(neighbour(cell, result.corners.data() + first, result.corners.size() - first));
    result.start.push_back(static_cast<std::int32_t>(result.corners.size()));
  }

  bool touches(Index point, Index cell) const
  {
    return std::binary_search(cells_.begin() + cellStart_[point], cells_.begin() + cellStart_[point + 1], cell);
  }

  /// The other cell that has all corners of a face.
  Index neighbour(Index cell, const Index* corners, std::size_t count) const
  {
    for (Index i = cellStart_[corners[0]]; i < cellStart_[corners[0] + 1]; ++i)
    {
      const Index candidate = cells_[i];
      if (candidate != cell &&
          std::all_of(corners + 1, corners + count, [&](Index point) { return touches(point, candidate); }))
      {
        return candidate;
      }
    }
    return -1;
  }

  const UnstructuredGrid& grid_;
  /// Visible cells by corner point: cells_[cellStart_[p]] .. cells_[cellStart_[p + 1]], ascending.
  std::vector<Index> cellStart_;
  std::vector<Index> cells_;
};
}

std::unique_ptr<GridTopology> makeGridTopology(const UnstructuredGrid& grid)
{
  return std::make_unique<UnstructuredGridTopology>(grid);
}
}
