#pragma once

#include "Extract/Boundary.h"
#include "Extract/Extract.h"

namespace strata
{
/// The borders of the regions in which each material's fraction is the largest, corrected in volume if asked for.
ExtractedInterfaces extractFromFractions(const Simulation& simulation, const ExtractOptions& options,
  const GridTopology& topology, const Boundary& boundary, Progress& progress);
}
