#pragma once

#include "Model/Progress.h"
#include "Native/SampleMaterials.h"

#include <array>
#include <vector>

namespace strata
{
/// The sample positions of one association on a rectilinear grid: products of three ascending lists.
struct SampleLattice
{
  using Position = std::array<Index, 3>;

  std::array<std::vector<double>, 3> coordinates;

  Index count(int axis) const { return static_cast<Index>(coordinates[static_cast<std::size_t>(axis)].size()); }
  double coordinate(int axis, Index i) const
  {
    return coordinates[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
  }
  Index index(const Position& p) const { return p[0] + count(0) * (p[1] + count(1) * p[2]); }
  Position position(Index sample) const
  {
    const Index row = sample / count(0);
    return { sample % count(0), row % count(1), row / count(1) };
  }
  Vector point(const Position& p) const { return { coordinate(0, p[0]), coordinate(1, p[1]), coordinate(2, p[2]) }; }
};

/// Visits the positions of a block, both corners included, the first axis fastest.
template<typename Visit>
void forEachPosition(const SampleLattice::Position& first, const SampleLattice::Position& last, const Visit& visit)
{
  for (Index k = first[2]; k <= last[2]; ++k)
  {
    for (Index j = first[1]; j <= last[1]; ++j)
    {
      for (Index i = first[0]; i <= last[0]; ++i)
      {
        visit(SampleLattice::Position{ i, j, k });
      }
    }
  }
}

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
