#pragma once

#include "OriginalInterfaces.h"

#include <cstdint>

/// The interfaces that were found last, for as long as what they follow from stays: the grid, and the fractions or ids.
/// Another choice of fields, or a time step in which fields alone change, does not find them again.
class KeptInterfaces
{
public:
  /// As originalInterfaces, whose result and warnings are kept unless the surfaces are given.
  strata::Interfaces get(const strata::conversion::CaseData& input, vtkDataObject* given,
    const strata::Simulation& simulation, double minimumVolumeFraction, strata::Warnings& warnings,
    strata::Progress& progress);

private:
  std::uint64_t fingerprint_ = 0;
  bool isKept_ = false;
  strata::Interfaces interfaces_;
  strata::Warnings warnings_;
};
