#pragma once

#include "OriginalInterfaces.h"

#include "PreparedInterfaces.h"

#include <cstdint>

/// The interfaces that were found last, for as long as what they follow from stays: the grid, and the fractions or ids.
/// Another choice of fields, or a time step in which fields alone change, does not find them again, nor makes them
/// ready for a build again.
class KeptInterfaces
{
public:
  /// As originalInterfaces, whose result and warnings are kept unless the surfaces are given.
  std::shared_ptr<strata::PreparedInterfaces> get(const strata::conversion::CaseData& input, vtkDataObject* given,
    const strata::Simulation& simulation, double minimumVolumeFraction, strata::Warnings& warnings,
    strata::Progress& progress);

  /// How often interfaces were extracted.
  int extractions() const { return extractions_; }

private:
  std::uint64_t fingerprint_ = 0;
  std::shared_ptr<strata::PreparedInterfaces> interfaces_; ///< null if none are kept
  strata::Warnings warnings_;
  int extractions_ = 0;
};
