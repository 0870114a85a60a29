#pragma once

#include "Extract/Extract.h"
#include "Extract/MixedRegion.h"

namespace strata
{
/// Moves the values at the vertices of a region so that each material's volume in each cell becomes its fraction.
///
/// Sweeps over all cells: the steps that a Newton iteration on the exact volumes asks for in each cell, averaged at
/// the vertices over the cells that ask. A material without a region in a cell is raised until it has one, if its
/// fraction is at least the minimum or it has a region in a cell around. What is then still wrong in a cell, the
/// values at its centre make right, which no other cell knows of. Values at outer vertices stay.
/// Smeared fractions are gathered at the interface first, if `options` want it; returns to what degree they were.
double correctVolumes(
  const MixedRegion& region, const ExtractOptions& options, MaterialValues& values, Progress& progress);
}
