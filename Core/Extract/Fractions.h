#pragma once

#include "Extract/GridTopology.h"
#include "Model/Progress.h"
#include "Model/Simulation.h"

#include <vector>

namespace strata
{
/// How much of a material there is at a place.
struct Share
{
  std::uint8_t material;
  double value;
};

/// A material's value in a list; 0 if it isn't listed.
double valueOf(const std::vector<Share>& shares, std::uint8_t material);
/// The position of the largest share, the first of equals. Precondition: there is one.
std::size_t largest(const std::vector<Share>& shares);

/// The volume fractions of a simulation by cell and by grid point, whichever of the two the simulation gives.
class Fractions
{
public:
  Fractions(const Simulation& simulation, const GridTopology& topology);

  bool atPoints() const { return atPoints_; }
  int materialCount() const { return static_cast<int>(arrays_.size()); }
  /// The materials of a cell, ascending; for data at points the mean over the cell's corners.
  void ofCell(Index cell, std::vector<Share>& result) const;
  /// The materials' volumes in a cell of the given volume, which they fill.
  void volumesOfCell(Index cell, double volume, std::vector<Share>& result) const;
  /// The materials at a grid point, ascending; for data in cells the mean over the visible cells around.
  void ofPoint(Index point, std::vector<Share>& result) const;

private:
  void mean(const std::vector<Index>& tuples, std::vector<Share>& result) const;

  const std::vector<ValueArray>& arrays_;
  const GridTopology& topology_;
  bool atPoints_;
};

/// The cells that interfaces may cross.
struct MixedCells
{
  /// Cells in which volumes are to be right, and the ring of cells around them; ascending.
  std::vector<Index> cells;
  /// The material with the largest fraction by cell; `none` for hidden cells.
  std::vector<std::uint8_t> dominant;
  static constexpr std::uint8_t none = 255;
};

/// Finds the cells round which the dominant material changes, those that hold another material with at least
/// `minimumFraction`, the cells that share a point with them, and the cells of `also` (one flag per cell).
MixedCells findMixedCells(const Fractions& fractions, const GridTopology& topology, double minimumFraction,
  const std::vector<std::uint8_t>& also, Progress& progress);
}
