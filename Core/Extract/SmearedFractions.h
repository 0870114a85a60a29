#pragma once

#include "Extract/CellVolumes.h"
#include "Extract/MixedRegion.h"

#include <vector>

namespace strata
{
/// Fractions that a solver smears over several cells across an interface hold the interface's place as a sum over
/// those cells, not one by one. This gives what lies off the interface back to the cells that it crosses, so that
/// correction moves the interface instead of tearing it up.
class SmearedFractions
{
public:
  /// Measures how much the fractions are smeared. `volumes` are those of the interface before its correction; both
  /// arguments must outlive it.
  SmearedFractions(const MixedRegion& region, const CellVolumes& volumes, Progress& progress);

  /// 0 for sharp fractions, where nothing is to be given back; 1 for smeared ones.
  double degree() const { return degree_; }

  /// Off the interface, where the fractions of one material clearly lead, the planes of smeared cells put sheets among
  /// the distances `values`: there, the fractions over the cells' size take their place. Near it distances stay, which
  /// make a smoother interface.
  void clearOffInterface(MaterialValues& values, Progress& progress) const;

  /// The volumes that the materials are to have, by cell: those that they have and the cell's part of what is wrong
  /// around. What is wrong in a cell goes to the nearest cells, at most three rings away, in which the same two
  /// materials touch, in proportion to the area, and then from those along the interface; where there are none it
  /// stays. Sums over the cells stay.
  std::vector<std::vector<Share>> targets(Progress& progress) const;

private:
  std::vector<Share> given(std::int32_t cell) const;
  void addVolumes(std::int32_t cell, std::vector<Share>& lacking) const;

  const MixedRegion& region_;
  const CellVolumes& volumes_;
  double degree_ = 0.0;
};
}
