#pragma once

#include "Geometry/SharedPoints.h"
#include "Model/Progress.h"
#include "Model/Representation.h"

#include <vector>

namespace strata
{
/// A tetrahedron of one material within a cell.
struct CellPiece
{
  Index cell = 0;
  std::int32_t material = 0;
  /// Its four corners in the list of uses, or -1 if it is the whole cell.
  Index corners = -1;
};

/// The pieces of all cells, ascending by cell and material. A corner's owner is the piece's material.
struct CellPieces
{
  std::vector<CellPiece> pieces;
  std::vector<PointUse> corners;
};

/// Cuts the cells of a representation into pieces of the given materials.
CellPieces cutCells(const Representation& representation, MaterialSet materials, Progress& progress);
}
