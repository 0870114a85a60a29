#pragma once

#include "Conversion/InputGrid.h"

namespace strata::conversion
{
/// Wedges of the two orientations that files have become those of VTK: the triangle of the first three corners
/// turns its normal away from the other three.
void orientWedges(UnstructuredGrid& grid);

/// The volumes of the cells together, and of the smallest.
struct CheckedVolumes
{
  double sum = 0.0;
  double smallest = 0.0;
};

/// Throws InvalidInput that names the first cell that is inverted or has no volume.
CheckedVolumes checkCells(const InputGrid& input);

/// True if the cells leave nothing of the box round them but rounding errors.
bool fillsBox(const UnstructuredGrid& grid, const CheckedVolumes& volumes);
}
