#pragma once

#include "Extract/Boundary.h"
#include "Extract/Extract.h"

namespace strata
{
/// The faces between cells of different materials, and those towards the outside. Flat faces are cut along the
/// diagonals from their lowest corner, others into a fan about their centre.
ExtractedInterfaces extractFromIds(
  const Simulation& simulation, const GridTopology& topology, const Boundary& boundary, Progress& progress);
}
