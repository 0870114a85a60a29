#pragma once

#include "Extract/ReplacedCells.h"
#include "Model/Errors.h"
#include "Model/Progress.h"

namespace strata
{
/// What an unstructured grid's cells come to.
struct UsableCells
{
  /// The polyhedra that cells with repeated corners collapse to (a hexahedron to a wedge or a pyramid, say).
  ReplacedCells replaced;
  /// The cells of the grid that are hidden or no closed polyhedron; empty if none is.
  std::vector<std::uint8_t> hidden;
  Warnings warnings; ///< names the first of the cells that can't be used, and their number
};

UsableCells findUsableCells(const UnstructuredGrid& grid, Progress& progress);
}
