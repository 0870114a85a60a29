#pragma once

#include "Conversion/ReadSimulation.h"

class vtkPartitionedDataSetCollection;

namespace strata::conversion
{
/// Adds the blocks that a simulation was read from as the block `grid` of a collection, with the cell arrays
/// `volume_error_<m>` (reconstructed minus given volume; NaN in cells that took no part). Blocks without cells of a
/// volume are left out.
void writeGridErrors(const ReadSimulationResult& read, const std::vector<std::vector<double>>& cellVolumeErrors,
  vtkPartitionedDataSetCollection* output);
}
