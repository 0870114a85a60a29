#pragma once

#include "Cell.h"
#include "Options.h"

#include <array>
#include <cstddef>
#include <vector>

namespace impact
{
/// The box, in cm, and the cells of the coarsest grid.
constexpr double lowerCorner[3] = { 0, 0, -16 };
constexpr double upperCorner[3] = { 12, 12, 4.8 };
constexpr int coarseCells[3] = { 32, 32, 52 };

/// The state of the simulation.
struct Simulation
{
  explicit Simulation(const Options& options);

  std::size_t cellAt(int i, int j, int k) const { return i + stride[1] * j + stride[2] * k; }
  double cellVolume() const { return spacing[0] * spacing[1] * spacing[2]; }

  /// Outward normal, in units of cells, of the projectile (0) or the void (1) in a cell: Youngs' stencil.
  std::array<double, 3> outwardNormal(int which, const std::array<int, 3>& index) const;

  Options options;
  Metals metals;
  std::array<int, 3> count;
  std::array<double, 3> spacing;
  std::array<std::size_t, 3> stride;
  std::vector<Cell> cells;
  /// Fractions of the projectile (0) and the void (1) as they were before the current sweep, and as it makes them.
  std::array<std::vector<float>, 2> fractions, newFractions;
  /// Left through the open sides, or deleted as dust.
  std::array<double, 2> lostMass = { 0, 0 };
};

/// Puts the block and, a gap above it, the projectile into the cells.
void setInitialState(Simulation& simulation, double gap);

/// One directional step of all cells; returns the largest (|u| + c) / h that was seen.
double sweep(Simulation& simulation, int axis, double timeStep);

/// Writes `<dir>/impact_<32 factor>_<index>.vtr`: averages over the cells of a grid `factor` times the coarsest.
/// Throws std::runtime_error that names a file that can't be written.
void writeGrid(const Simulation& simulation, int factor, int index, double time);

/// Prints a line of conserved quantities and extremes.
void report(const Simulation& simulation, int step, double time, double timeStep);
}
