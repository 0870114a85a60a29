#pragma once

#include "Extract/CellCutter.h"
#include "Extract/MixedRegion.h"

#include <Eigen/Dense>
#include <tbb/enumerable_thread_specific.h>

#include <vector>

namespace strata
{
/// What a cell's materials have and what they are to have.
struct CellVolume
{
  double total = 0.0;         ///< the cell's volume
  std::vector<Share> volumes; ///< of the materials' regions
  Eigen::MatrixXd slopes;     ///< how those change when the materials' values rise
  std::vector<Share> targets; ///< volumes that they are to have
  std::uint64_t reached = 0;  ///< materials that have a region in the cell or in one at its points (bits)
};

/// Keeps the volumes in the cells of a complex up to date while the values at its vertices change.
class CellVolumes
{
public:
  /// All arguments must outlive it.
  CellVolumes(const MixedRegion& region, const MaterialValues& values, double minimumFraction, Progress& progress);

  /// Measures the cells that have a vertex marked in `changed`. A material that has less than the minimum fraction of
  /// a cell, and no region around it, is not asked for: its target goes to the cell's other materials.
  void update(const std::vector<std::uint8_t>& changed);

  /// Sets what the materials of a cell are to have from now on, in place of its fractions; the sum is the cell's
  /// volume.
  void replaceTargets(std::int32_t cell, std::vector<Share> targets);

  const CellVolume& operator[](std::int32_t cell) const { return cells_[cell]; }
  std::uint8_t winner(std::int32_t vertex) const { return winners_[vertex]; }
  const std::vector<std::uint8_t>& winners() const { return winners_; }

private:
  void measure(std::int32_t cell);
  void findTargets(std::int32_t cell);

  const CellComplex& complex_;
  const CellsAround& around_;
  const MaterialValues& values_;
  const Fractions& fractions_;
  double minimumFraction_;
  Progress& progress_;
  std::vector<std::uint8_t> winners_;
  std::vector<std::uint64_t> reach_; ///< by vertex: materials that have a region in a cell around
  std::vector<CellVolume> cells_;
  std::vector<std::uint8_t> replaced_; ///< by cell: its targets were replaced
  struct Workspace
  {
    CellCutter cutter;
    CellCutter::Regions regions;
  };
  tbb::enumerable_thread_specific<Workspace> workspaces_;
};
}
