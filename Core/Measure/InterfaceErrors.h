#pragma once

#include "Geometry/TetrahedronLocator.h"
#include "Measure/RepresentedRegions.h"

namespace strata
{
/// Errors of all interfaces: one report for each pair of materials that touch in the original or the representation.
/// `tolerance`: width to which Hausdorff intervals close, in the data's length unit.
std::vector<InterfaceErrorReport> measureInterfaces(const Representation& representation, const Interfaces& original,
  const PairSurfaces& represented, const TetrahedronLocator& locator, double tolerance, Progress& progress);

/// Distances between the boundaries of the materials' regions; `interfaces` are the errors of the same surfaces.
std::vector<RegionErrorReport> measureRegions(const Interfaces& original, const PairSurfaces& represented,
  const std::vector<InterfaceErrorReport>& interfaces, double tolerance, Progress& progress);
}
