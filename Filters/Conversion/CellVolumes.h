#pragma once

#include "Model/Grid.h"
#include "Model/Simulation.h"

#include "Measure/Measure.h"

namespace strata::conversion
{
/// The signed volume of a cell: exact for straight and for warped (bilinear) faces, positive for VTK's order of
/// corners. Polyhedra count as convex: their volume is positive whichever way their faces turn.
double cellVolume(const UnstructuredGrid& grid, Index cell);

/// Volume and mass of each material by its fractions (or ids) and the field `density`, if that lives in cells.
OriginalVolumes originalVolumes(const Simulation& simulation);
}
