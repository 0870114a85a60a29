#pragma once

#include "Conversion/CurvedCells.h"

#include <array>
#include <vector>

namespace strata::conversion
{
/// A regular lattice in a shape's unit cell: the parameters of its points, as VTK has them, and the linear cells
/// between them.
struct ShapeLattice
{
  std::vector<std::array<double, 3>> points;
  std::vector<CurvedPattern::Piece> pieces;
};

/// The lattice of a tetrahedron (degree cubed tetrahedra), hexahedron, wedge (both: degree cubed of the same, with a
/// degree per axis; the first counts for both axes of a wedge's triangle) or pyramid of degree 2 (six pyramids, four
/// tetrahedra).
ShapeLattice latticeOf(CellShape shape, const std::array<int, 3>& degrees);
}
