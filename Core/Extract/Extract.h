#pragma once

#include "Model/Errors.h"
#include "Model/Interfaces.h"
#include "Model/Progress.h"
#include "Model/Simulation.h"

namespace strata
{
struct ExtractOptions
{
  /// Drive each cell's reconstructed volumes to its volume fractions.
  bool volumeCorrection = true;
  /// Where a solver smears fractions over several cells, let these cells' sums place the interface, not each cell.
  bool gatherSmearedFractions = true;
  /// Pieces that win nowhere are kept where their fraction is at least this.
  double minimumVolumeFraction = 0.1;
};

/// What the extraction left over for one material, in the volume unit of the data.
struct VolumeReport
{
  double given = 0.0;         ///< sum over cells of fraction times volume
  double reconstructed = 0.0; ///< volume of the region that the interfaces bound
  double largestError = 0.0;  ///< over the cells
  double meanError = 0.0;     ///< over the mixed cells
};

struct ExtractedInterfaces
{
  Interfaces interfaces;
  std::vector<VolumeReport> volumes; ///< one per material
  double smearing = 0.0;             ///< how much of smeared fractions was gathered at the interface, 0 to 1
  /// [material][cell]: reconstructed minus given volume. Filled for cells with several materials, 0 elsewhere.
  std::vector<std::vector<double>> cellVolumeErrors;
  Warnings warnings;
};

/// Finds the surfaces between the materials of a simulation from its volume fractions or material ids.
/// Surfaces are ordered by (positive, negative) with positive < negative. See Documentation/Algorithm.md.
ExtractedInterfaces extractInterfaces(const Simulation& simulation, const ExtractOptions& options, Progress& progress);
}
