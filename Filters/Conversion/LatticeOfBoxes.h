#pragma once

#include "Conversion/InputGrid.h"

namespace strata::conversion
{
/// Where the cells of an unstructured grid that fills its box are the boxes of a rectilinear one, in whatever order,
/// the grid becomes that rectilinear one: the same data give the same result in every kind of grid, and faster.
/// Coordinates are the same within Weld.h's tolerance. Grids with curved cells, and those in which cells that touch
/// have points of their own, stay. Cost: n log n for a grid of boxes, no more than up to the first other cell else.
void recognizeLattice(InputGrid& input);
}
