#pragma once

#include "Conversion/ReadSimulation.h"

class vtkPartitionedDataSetCollection;

namespace strata::conversion
{
/// Adds an input grid as the block `grid` of a collection, with the cell arrays `volume_error_<m>` (reconstructed minus
/// given volume; NaN in cells that took no part).
void writeGridErrors(vtkDataObject* grid, const ReadSimulationResult& read,
  const std::vector<std::vector<double>>& cellVolumeErrors, vtkPartitionedDataSetCollection* output);
}
