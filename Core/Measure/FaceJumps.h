#pragma once

#include "Measure/RepresentedRegions.h"

namespace strata
{
/// The interfaces that lie on faces between two cells: where the cells have different materials at the same points of
/// their common face. That happens only where they don't hold the same set of materials: a cell's linear functions on
/// its face are those of its vertices, the same from both sides.
PairSurfaces surfacesOnFaces(const Representation& representation, Progress& progress);
}
