#pragma once

#include "Material.h"

#include <array>

namespace impact
{
/// Position of a symmetric tensor's component among the six that are stored.
constexpr int symmetric[3][3] = { { 0, 3, 4 }, { 3, 1, 5 }, { 4, 5, 2 } };

/// A cell's contents, per unit of its undeformed volume. Both metals share velocity and deviator.
struct Cell
{
  double fraction[2] = { 0, 0 }; ///< volume
  double mass[2] = { 0, 0 };
  double energy[2] = { 0, 0 }; ///< internal
  double velocity[3] = { 0, 0, 0 };
  double deviator[6] = { 0, 0, 0, 0, 0, 0 }; ///< of the stress, see `symmetric`

  double totalMass() const { return mass[0] + mass[1]; }
  double solid() const { return fraction[0] + fraction[1]; }
};

/// What a sweep needs to know of a cell before the Lagrangian step.
struct CellState
{
  double pressure = 0; ///< mean over the cell, the void's 0 included
  double bulkModulus[2] = { 1, 1 };
  double longitudinalSpeed = 0;
  double shearSpeed = 0;
  double shearModulus = 0;
  double yieldStrength = 0;
  double hugoniotSlope = 0;
};

/// Relaxes the pressures inside a cell (towards 0 beside a void, to a common one between two metals) and
/// tells its mean pressure, moduli and sound speeds.
CellState relax(Cell& cell, const Metals& metals);
}
