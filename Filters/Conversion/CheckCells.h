#pragma once

#include "Conversion/InputGrid.h"

namespace strata::conversion
{
/// Wedges of the two orientations that files have become those of VTK: the triangle of the first three corners
/// turns its normal away from the other three.
void orientWedges(UnstructuredGrid& grid);

/// Throws InvalidInput that names the first cell that is inverted or has no volume.
void checkCells(const InputGrid& input);
}
