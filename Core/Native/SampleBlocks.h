#pragma once

#include "Model/Progress.h"
#include "Native/SampleLattice.h"
#include "Native/SampleMaterials.h"

#include <array>
#include <vector>

namespace strata
{
/// The materials in blocks of 8 x 8 x 8 samples of a lattice: finds the nearest sample of a material where
/// there is none close by.
class SampleBlocks
{
public:
  SampleBlocks(const SampleLattice& lattice, const SampleMaterials& materials, Progress& progress);

  /// The sample of m nearest to a point; among equally near ones the lowest index. -1 if there is none.
  /// Cost: a look at every block, and at the samples of few.
  Index nearest(
    const SampleLattice& lattice, const SampleMaterials& materials, MaterialId m, const Vector& point) const;

private:
  struct Extent
  {
    SampleLattice::Position first;
    SampleLattice::Position last;
  };
  Extent samplesOf(const SampleLattice& lattice, Index block) const;

  std::array<Index, 3> counts_{};
  std::vector<MaterialSet> sets_;
};
}
