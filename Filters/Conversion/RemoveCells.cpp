#include "Conversion/RemoveCells.h"

#include <cstddef>
#include <utility>

namespace strata::conversion
{
namespace
{
/// Appends the entries first .. last - 1 of one list to another.
void append(const std::vector<Index>& from, Index first, Index last, std::vector<Index>& to)
{
  to.insert(to.end(), from.begin() + first, from.begin() + last);
}

/// Copies the faces of a cell of `from` to the end of `to`.
void appendFaces(const UnstructuredGrid& from, std::size_t cell, UnstructuredGrid& to)
{
  for (Index f = from.faceOffsets[cell]; f < from.faceOffsets[cell + 1]; ++f)
  {
    const auto face = static_cast<std::size_t>(f);
    append(from.faceCorners, from.faceStart[face], from.faceStart[face + 1], to.faceCorners);
    to.faceStart.push_back(static_cast<Index>(to.faceCorners.size()));
  }
  to.faceOffsets.push_back(static_cast<Index>(to.faceStart.size()) - 1);
}
}

void removeCells(InputGrid& input, const std::vector<Index>& cells)
{
  auto& grid = std::get<UnstructuredGrid>(input.grid);
  const bool polyhedra = !grid.faceOffsets.empty();
  UnstructuredGrid kept;
  kept.cornerOffsets.push_back(0);
  if (polyhedra)
  {
    kept.faceOffsets.push_back(0);
    kept.faceStart.push_back(0);
  }
  std::vector<Index> cellSource;
  std::vector<Index> cornerSource;
  auto next = cells.begin();
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    if (next != cells.end() && *next == cell)
    {
      ++next;
      continue;
    }
    const auto c = static_cast<std::size_t>(cell);
    append(grid.corners, grid.cornerOffsets[c], grid.cornerOffsets[c + 1], kept.corners);
    if (!input.cornerSource.empty())
    {
      append(input.cornerSource, grid.cornerOffsets[c], grid.cornerOffsets[c + 1], cornerSource);
    }
    kept.cornerOffsets.push_back(static_cast<Index>(kept.corners.size()));
    kept.shapes.push_back(grid.shapes[c]);
    cellSource.push_back(input.cellSource[c]);
    if (polyhedra)
    {
      appendFaces(grid, c, kept);
    }
  }
  kept.points = std::move(grid.points);
  grid = std::move(kept);
  input.cellSource = std::move(cellSource);
  input.cornerSource = std::move(cornerSource);
}
}
