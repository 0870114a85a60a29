#pragma once

#include "Model/Buffer.h"
#include "Model/Progress.h"
#include "Model/Simulation.h"

#include <cstdint>
#include <vector>

namespace strata
{
/// The materials that each sample of one association counts for: two bytes per sample, an index into a
/// table of the sets that occur.
class SampleMaterials
{
public:
  Index size() const { return indices_.size(); }
  MaterialSet operator[](Index sample) const { return table_[indices_[sample]]; }
  /// All materials that some sample counts for.
  MaterialSet present() const { return present_; }

private:
  friend SampleMaterials findSampleMaterials(const Simulation&, Association, double, Progress&);

  Buffer<std::uint16_t> indices_;
  std::vector<MaterialSet> table_;
  MaterialSet present_;
};

/// Finds the materials with fields that each cell (or point) counts for: those whose volume fraction is at
/// least `minimumVolumeFraction`, and the one with the largest fraction (ties: the lower index).
///
/// Where fractions and samples are associated differently, a sample's fractions are the mean over the
/// corners of its cell, or over the visible cells round its point. Material ids count where they are, and
/// at a point for every visible cell round it. Hidden cells, and points with hidden cells only, count for none.
/// Throws InvalidInput for ids that are no materials.
SampleMaterials findSampleMaterials(
  const Simulation& simulation, Association association, double minimumVolumeFraction, Progress& progress);
}
