#include "LineSweep.h"

#include <algorithm>
#include <cmath>

namespace impact
{
namespace
{
/// A volume fraction, or a mass, below this is nothing.
constexpr double dust = 1e-8;

/// A cell that is full but for rounding has fractions that sum to exactly 1.
void fillUp(Cell& cell)
{
  const double sum = cell.solid();
  if (sum <= 1 - 1e-5)
  {
    return;
  }
  for (double& fraction : cell.fraction)
  {
    fraction /= sum;
  }
  if (cell.fraction[0] > 0 && cell.fraction[1] > 0)
  {
    cell.fraction[1] = 1 - cell.fraction[0];
  }
}
}

void LineSweep::computeFluxes(int i)
{
  const Cell& c = cell(i);
  const double volume = volumes_[i + 2];
  const double left = displacements_[i];
  const double right = displacements_[i + 1];
  if (c.totalMass() <= 0 || (right <= 0 && left >= 0))
  {
    return;
  }
  double contents[3] = { c.fraction[0], c.fraction[1], std::max(0.0, volume - c.fraction[0] - c.fraction[1]) };
  std::array<int, 3> index = index_;
  index[axis_] = i;
  const MovedCell moved = { c, cell(i - 1), cell(i + 1), volume, index, axis_ };
  if (right > 0)
  {
    fluxes_[i + 1] = outflow(simulation_, moved, { 1 - right / volume, 1, 1 }, contents);
  }
  if (left < 0)
  {
    fluxes_[i] = outflow(simulation_, moved, { 0, -left / volume, -1 }, contents);
  }
}

void LineSweep::remapCell(int i)
{
  Cell& c = cell(i);
  const Flux& in = fluxes_[i];
  const Flux& out = fluxes_[i + 1];
  const double mass = c.totalMass();
  double kinetic = in.kinetic - out.kinetic;
  for (int x = 0; x < 3; ++x)
  {
    kinetic += 0.5 * mass * c.velocity[x] * c.velocity[x];
    c.velocity[x] = c.velocity[x] * mass + in.momentum[x] - out.momentum[x];
  }
  for (int x = 0; x < 6; ++x)
  {
    c.deviator[x] = c.deviator[x] * mass + in.deviator[x] - out.deviator[x];
  }
  for (int k = 0; k < 2; ++k)
  {
    c.fraction[k] += in.volume[k] - out.volume[k];
    c.mass[k] += in.mass[k] - out.mass[k];
    c.energy[k] += in.energy[k] - out.energy[k];
    if (c.fraction[k] < dust || c.mass[k] < dust)
    {
      lostMass_[k] += c.mass[k];
      c.fraction[k] = c.mass[k] = c.energy[k] = 0;
    }
  }
  fillUp(c);
  settle(c, kinetic);
  const std::size_t id = base_ + i * simulation_.stride[axis_];
  simulation_.cells[id] = c;
  simulation_.newFractions[0][id] = float(c.fraction[0]);
  simulation_.newFractions[1][id] = float(std::max(0.0, 1 - c.solid()));
}

/// Turns momentum back into velocity. Kinetic energy that mixing lost becomes heat, but not at a free surface.
void LineSweep::settle(Cell& c, double kinetic)
{
  const double mass = c.totalMass();
  if (mass <= 0)
  {
    std::fill(std::begin(c.velocity), std::end(c.velocity), 0.0);
    std::fill(std::begin(c.deviator), std::end(c.deviator), 0.0);
    return;
  }
  double squaredSpeed = 0;
  for (double& x : c.velocity)
  {
    x /= mass;
    squaredSpeed += x * x;
  }
  const double limit = 3 * simulation_.options.speed;
  if (squaredSpeed > limit * limit)
  {
    for (double& x : c.velocity)
    {
      x *= limit / std::sqrt(squaredSpeed);
    }
  }
  for (double& x : c.deviator)
  {
    x /= mass;
  }
  const double heat = kinetic - 0.5 * mass * squaredSpeed;
  if (heat > 0 && c.solid() > 1 - 1e-9)
  {
    for (int k = 0; k < 2; ++k)
    {
      c.energy[k] += heat * c.mass[k] / mass;
    }
  }
}

double sweep(Simulation& simulation, int axis, double timeStep)
{
  const int p = axis == 0 ? 1 : 0;
  const int q = axis == 2 ? 1 : 2;
  const int rows = simulation.count[p] * simulation.count[q];
  double fastest = 0, lost0 = 0, lost1 = 0;
#pragma omp parallel reduction(max : fastest) reduction(+ : lost0, lost1)
  {
    LineSweep line(simulation, axis, timeStep);
#pragma omp for schedule(dynamic, 32)
    for (int row = 0; row < rows; ++row)
    {
      std::array<int, 3> index = { 0, 0, 0 };
      index[p] = row % simulation.count[p];
      index[q] = row / simulation.count[p];
      fastest = std::max(fastest, line.advance(index));
    }
    lost0 += line.lostMass()[0];
    lost1 += line.lostMass()[1];
  }
  simulation.lostMass[0] += lost0;
  simulation.lostMass[1] += lost1;
  simulation.fractions = simulation.newFractions;
  return fastest;
}
}
