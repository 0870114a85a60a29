#pragma once

#include "Simulation.h"

namespace impact
{
/// What passes a face during a step, towards the positive axis.
struct Flux
{
  double volume[2] = { 0, 0 };
  double mass[2] = { 0, 0 };
  double energy[2] = { 0, 0 };
  double momentum[3] = { 0, 0, 0 };
  double deviator[6] = { 0, 0, 0, 0, 0, 0 }; ///< times mass
  double kinetic = 0;
};

/// The monotonised central slope of three values with differences a and b.
double limitedSlope(double a, double b);

/// A cell after its Lagrangian step, between its neighbours.
struct MovedCell
{
  const Cell& cell;
  const Cell& before;
  const Cell& behind;
  double volume; ///< of metals and void together; 1 before the step
  std::array<int, 3> index;
  int axis;
};

/// The slab of a moved cell that leaves it, in fractions of the cell.
struct Slab
{
  double from, to;
  int side; ///< +1: through the right face, -1: through the left one
};

/// What leaves a moved cell with a slab. `left` holds the volumes of projectile, block and void that are
/// still in the cell, and is reduced.
Flux outflow(const Simulation& simulation, const MovedCell& moved, const Slab& slab, double left[3]);
}
