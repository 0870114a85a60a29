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

/// Takes the cells out of the grid that are inverted or have no volume, with a warning that names the first and tells
/// how many there are. Throws InvalidInput that names the first if no others are left.
CheckedVolumes dropCellsWithoutVolume(InputGrid& input);

/// Takes cells out that stand a second time, with the same corners in any order, with a warning as above. The volumes
/// lose theirs.
void dropRepeatedCells(InputGrid& input, CheckedVolumes& volumes);

/// True if the cells leave nothing of the box round them but rounding errors.
bool fillsBox(const UnstructuredGrid& grid, const CheckedVolumes& volumes);
}
