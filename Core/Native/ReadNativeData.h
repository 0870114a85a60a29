#pragma once

#include "Model/Errors.h"
#include "Model/NativeData.h"
#include "Model/Progress.h"
#include "Model/Simulation.h"

#include <memory>

namespace strata
{
struct NativeOptions
{
  /// A sample counts for a material from this volume fraction on (and for the one with the largest).
  double minimumVolumeFraction = 0.1;
};

/// Makes the simulation's fields ready for the refinement. The result keeps the simulation's arrays alive.
/// Throws InvalidInput where a field is not finite in a cell that counts for a material (names field, cell, value).
std::unique_ptr<NativeData> readNativeData(
  const Simulation& simulation, const NativeOptions& options, Progress& progress);
}
