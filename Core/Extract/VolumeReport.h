#pragma once

#include "Extract/CellCutter.h"
#include "Extract/Extract.h"
#include "Extract/Fractions.h"

namespace strata
{
/// Compares the volumes of the regions with the given ones, cell by cell: fills `volumes` and `cellVolumeErrors`.
void reportVolumes(const CellComplex& complex, const MaterialValues& values, const std::vector<std::uint8_t>& winners,
  const Fractions& fractions, const GridTopology& topology, const MixedCells& mixed, ExtractedInterfaces& result,
  Progress& progress);
}
