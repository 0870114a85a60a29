#pragma once

#include "Measure/OriginalMaterial.h"
#include "Model/Progress.h"
#include "Model/Representation.h"

namespace strata
{
struct VolumeEstimate
{
  double volume = 0.0;
  double standardError = 0.0;
  double nearGaps = 0.0; ///< the part of the volume where the original interfaces leave the side open
};

/// The volume in which the represented material (the smallest distance) is not the original one (the side of the
/// original interfaces).
///
/// Cells that no original interface meets are exact: one original material fills them. The others are sampled at points
/// stratified over each cell, at a position within its stratum that is a function of the cell's number and the
/// stratum's. The standard error takes a cell's points for independent ones, which stratified points beat.
VolumeEstimate misclassifiedVolume(
  const Representation& representation, const OriginalMaterial& original, Progress& progress);
}
