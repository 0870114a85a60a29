#include "Outflow.h"

#include "InterfacePlane.h"

#include <algorithm>
#include <cmath>

namespace impact
{
namespace
{
/// A part of a cell below this is nothing.
constexpr double tinyPart = 1e-9;

/// Volumes of projectile, block and void in a slab of the given volume, by planes: the void's, and the
/// projectile's where there is no void or all three meet; the block takes the rest.
void cutSlab(const Simulation& simulation, const MovedCell& moved, const Slab& slab, const double part[3],
  double volume, double out[3])
{
  int count = 0;
  int last = 2;
  for (int k = 0; k < 3; ++k)
  {
    if (part[k] > tinyPart)
    {
      ++count;
      last = k;
    }
  }
  if (count <= 1)
  {
    out[last] = volume;
    return;
  }
  const auto planeVolume = [&](int which, double fraction) {
    const InterfacePlane plane(simulation.outwardNormal(which, moved.index), fraction);
    return moved.volume * plane.slabVolume(moved.axis, slab.from, slab.to);
  };
  if (part[2] > tinyPart)
  {
    out[2] = planeVolume(1, part[2]);
  }
  if (part[2] <= tinyPart || count == 3)
  {
    out[0] = planeVolume(0, part[0]);
  }
  else if (part[0] > tinyPart)
  {
    out[0] = volume - out[2];
  }
  out[2] = std::min(out[2], volume);
  out[0] = std::min(out[0], volume - out[2]);
  out[1] = volume - out[2] - out[0];
}

/// Keeps what leaves within what is there; the excess goes to the void, the block, the projectile, in this order.
void limitToContents(double out[3], double left[3])
{
  double excess = 0;
  for (int k = 0; k < 3; ++k)
  {
    if (out[k] > left[k])
    {
      excess += out[k] - left[k];
      out[k] = left[k];
    }
  }
  for (int k = 2; k >= 0 && excess > 0; --k)
  {
    const double room = std::min(excess, left[k] - out[k]);
    out[k] += room;
    excess -= room;
  }
  for (int k = 0; k < 3; ++k)
  {
    left[k] -= out[k];
  }
}

/// Mass and energy of the metals that leave, at the slab's centre; returns the mass of both.
double carryMetals(const MovedCell& moved, const double out[3], double half, int side, Flux& flux)
{
  const auto& [cell, before, behind, volume, index, axis] = moved;
  double total = 0;
  for (int k = 0; k < 2; ++k)
  {
    if (out[k] <= 0 || cell.fraction[k] <= 0)
    {
      continue;
    }
    double density = cell.mass[k] / cell.fraction[k];
    double energy = cell.energy[k] / cell.mass[k];
    const bool pure = cell.fraction[k] > (1 - tinyPart) * volume && before.fraction[k] > 0 && behind.fraction[k] > 0 &&
                      before.fraction[1 - k] == 0 && behind.fraction[1 - k] == 0;
    if (pure)
    {
      density += half * limitedSlope(
                          density - before.mass[k] / before.fraction[k], behind.mass[k] / behind.fraction[k] - density);
      energy +=
        half * limitedSlope(energy - before.energy[k] / before.mass[k], behind.energy[k] / behind.mass[k] - energy);
    }
    flux.volume[k] = side * out[k];
    flux.mass[k] = side * std::min(density * out[k], cell.mass[k]);
    flux.energy[k] = flux.mass[k] * energy;
    total += flux.mass[k];
  }
  return total;
}
}

double limitedSlope(double a, double b)
{
  if (a * b <= 0)
  {
    return 0;
  }
  const double central = 0.5 * (a + b);
  const double limit = 2 * std::min(std::fabs(a), std::fabs(b));
  return std::copysign(std::min(std::fabs(central), limit), central);
}

Flux outflow(const Simulation& simulation, const MovedCell& moved, const Slab& slab, double left[3])
{
  const auto& [cell, before, behind, volume, index, axis] = moved;
  const double part[3] = { cell.fraction[0] / volume, cell.fraction[1] / volume,
    1 - (cell.fraction[0] + cell.fraction[1]) / volume };
  double out[3] = { 0, 0, 0 };
  cutSlab(simulation, moved, slab, part, (slab.to - slab.from) * volume, out);
  limitToContents(out, left);

  Flux flux;
  const double half = 0.5 * (1 - (slab.to - slab.from)) * slab.side;
  const double total = carryMetals(moved, out, half, slab.side, flux);
  const bool smooth = part[2] <= tinyPart && before.solid() > 0.5 && behind.solid() > 0.5;
  const auto carried = [&](double a, double b, double c) {
    return total * (smooth ? b + half * limitedSlope(b - a, c - b) : b);
  };
  for (int i = 0; i < 3; ++i)
  {
    flux.momentum[i] = carried(before.velocity[i], cell.velocity[i], behind.velocity[i]);
  }
  for (const double momentum : flux.momentum)
  {
    flux.kinetic += total != 0 ? 0.5 * momentum * momentum / total : 0;
  }
  for (int i = 0; i < 6; ++i)
  {
    flux.deviator[i] = carried(before.deviator[i], cell.deviator[i], behind.deviator[i]);
  }
  return flux;
}
}
