#pragma once

#include "Extract/CellCutter.h"
#include "Extract/Extract.h"
#include "Extract/MixedRegion.h"

namespace strata
{
/// Compares the volumes of the regions with the given ones, cell by cell: fills `volumes` and `cellVolumeErrors`.
void reportVolumes(const MixedRegion& region, const MaterialValues& values, const std::vector<std::uint8_t>& winners,
  ExtractedInterfaces& result, Progress& progress);
}
