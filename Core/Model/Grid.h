#pragma once

#include "Geometry/Box.h"
#include "Model/Ids.h"

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

namespace strata
{
/// A simulation grid whose points are the products of three ascending coordinate lists.
/// Point (i,j,k) has index i + nx (j + ny k), cells likewise with nx - 1, ny - 1.
struct RectilinearGrid
{
  std::array<std::vector<double>, 3> coordinates;
  /// One per cell, 1 where the cell is hidden (blanked); empty if none is.
  std::vector<std::uint8_t> hidden;

  Index pointCount(int axis) const { return static_cast<Index>(coordinates[axis].size()); }
  Index cellCount(int axis) const { return pointCount(axis) - 1; }
  Index pointCount() const { return pointCount(0) * pointCount(1) * pointCount(2); }
  Index cellCount() const { return cellCount(0) * cellCount(1) * cellCount(2); }
};

/// The shapes of native cells. Corners are numbered as VTK numbers them.
enum class CellShape : std::uint8_t
{
  Tetrahedron,
  Hexahedron,
  Wedge,
  Pyramid,
  Polyhedron
};

/// Any other simulation grid: points and cells that share them.
struct UnstructuredGrid
{
  std::vector<Vector> points;
  std::vector<CellShape> shapes;
  /// Corner points of cell c: corners[cornerOffsets[c]] .. corners[cornerOffsets[c + 1]].
  std::vector<Index> cornerOffsets;
  std::vector<Index> corners;
  /// Faces of the cells of shape Polyhedron (empty if there are none): faces of cell c:
  /// faceOffsets[c] .. faceOffsets[c + 1] are positions in `faceStart`; face f has the points
  /// faceCorners[faceStart[f]] .. faceCorners[faceStart[f + 1]].
  std::vector<Index> faceOffsets;
  std::vector<Index> faceStart;
  std::vector<Index> faceCorners;
  /// One per cell, 1 where the cell is hidden or a duplicate (ghost) of another; empty if none is.
  std::vector<std::uint8_t> hidden;

  Index pointCount() const { return static_cast<Index>(points.size()); }
  Index cellCount() const { return static_cast<Index>(shapes.size()); }
};

using Grid = std::variant<RectilinearGrid, UnstructuredGrid>;

/// The box round all points of a grid.
Box bounds(const Grid& grid);
Index cellCount(const Grid& grid);
Index pointCount(const Grid& grid);
}
