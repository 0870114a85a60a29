#pragma once

#include "Extract/CellsAround.h"
#include "Extract/MaterialValues.h"

#include <cstdint>
#include <vector>

namespace strata
{
/// The part of a grid that interfaces may cross, cut into tetrahedra.
struct MixedRegion
{
  /// Finds and cuts the cells. The first two arguments must outlive the region; `minimumFraction` and `also` are
  /// those of findMixedCells.
  MixedRegion(const GridTopology& topology, const Fractions& fractions, double minimumFraction,
    const std::vector<std::uint8_t>& also, Progress& progress);

  const GridTopology& topology;
  const Fractions& fractions;
  MixedCells mixed;
  CellComplex complex;
  CellsAround around;
  std::vector<std::uint8_t> outer; ///< by vertex: cells outside the region share it, so its values stay
};

/// Makes the material that dominates the cells round each outer vertex win there, so that no interface leaves the
/// region into cells that are not cut. `values` are distances.
void keepInterfacesInside(const MixedRegion& region, MaterialValues& values, Progress& progress);
}
