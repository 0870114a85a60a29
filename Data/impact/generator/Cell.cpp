#include "Cell.h"

#include <algorithm>
#include <cmath>

namespace impact
{
namespace
{
/// A cell's metals before they relax.
struct Parts
{
  double pressure[2] = { 0, 0 };
  double softness[2] = { 0, 0 };
};

Parts evaluateParts(const Cell& cell, const Metals& metals, CellState& state)
{
  Parts parts;
  for (int k = 0; k < 2; ++k)
  {
    if (cell.fraction[k] <= 0)
    {
      continue;
    }
    const double density = cell.mass[k] / cell.fraction[k];
    const double energy = cell.energy[k] / cell.mass[k];
    const Pressure pressure = equationOfState(metals.material[k], density, energy);
    parts.pressure[k] = pressure.value;
    state.bulkModulus[k] = pressure.bulkModulus;
    parts.softness[k] = softening(metals.material[k], density, energy);
  }
  return parts;
}

/// Whether a cell relaxes, and to which pressure.
bool findTarget(const Cell& cell, const Metals& metals, const CellState& state, const Parts& parts, double& target)
{
  const double solid = cell.solid();
  const double mean = (cell.fraction[0] * parts.pressure[0] + cell.fraction[1] * parts.pressure[1]) / solid;
  double spall = 0;
  for (int k = 0; k < 2; ++k)
  {
    spall += cell.fraction[k] / solid * metals.material[k].spallStrength * std::max(0.1, parts.softness[k]);
  }
  target = 0;
  if (1 - solid > 0 || mean < -spall)
  {
    return true;
  }
  if (cell.fraction[0] > 0 && cell.fraction[1] > 0)
  {
    const double weight0 = cell.fraction[0] / state.bulkModulus[0];
    const double weight1 = cell.fraction[1] / state.bulkModulus[1];
    target = (weight0 * parts.pressure[0] + weight1 * parts.pressure[1]) / (weight0 + weight1);
    return true;
  }
  return false;
}

void relaxTo(double target, Cell& cell, const Metals& metals, const CellState& state, Parts& parts)
{
  const double gap = 1 - cell.solid();
  double change[2] = { 0, 0 }; // of the volumes
  double sum = 0;
  for (int k = 0; k < 2; ++k)
  {
    if (cell.fraction[k] <= 0)
    {
      continue;
    }
    double strain = std::clamp((parts.pressure[k] - target) / state.bulkModulus[k], -0.1, 0.1);
    if (cell.mass[k] < 0.6 * metals.material[k].density * cell.fraction[k])
    {
      strain = std::min(strain, 0.0);
    }
    change[k] = strain * cell.fraction[k];
    sum += change[k];
  }
  if (sum > gap) // no more room than the void leaves
  {
    const double growth = std::max(change[0], 0.0) + std::max(change[1], 0.0);
    const double share = std::max(0.0, (growth - (sum - gap)) / growth);
    for (double& x : change)
    {
      x = x > 0 ? x * share : x;
    }
  }
  for (int k = 0; k < 2; ++k)
  {
    if (change[k] != 0)
    {
      cell.energy[k] -= (target + 0.5 * (parts.pressure[k] - target)) * change[k];
      parts.pressure[k] -= state.bulkModulus[k] * change[k] / cell.fraction[k];
      cell.fraction[k] += change[k];
    }
  }
}

void averageModuli(const Cell& cell, const Metals& metals, const Parts& parts, CellState& state)
{
  const double solid = cell.solid();
  double compliance = 0;
  for (int k = 0; k < 2; ++k)
  {
    if (cell.fraction[k] > 0)
    {
      const Material& material = metals.material[k];
      const double weight = cell.fraction[k] / solid;
      compliance += weight / state.bulkModulus[k];
      state.shearModulus += weight * material.shearModulus * std::max(0.05, parts.softness[k]);
      state.yieldStrength += weight * material.yieldStrength * metals.strength * parts.softness[k];
      state.hugoniotSlope += weight * material.hugoniotSlope;
    }
  }
  const double density = cell.totalMass() / solid;
  state.longitudinalSpeed = std::sqrt((1 / compliance + 4.0 / 3 * state.shearModulus) / density);
  state.shearSpeed = std::sqrt(state.shearModulus / density);
}
}

CellState relax(Cell& cell, const Metals& metals)
{
  CellState state;
  if (cell.solid() <= 0)
  {
    return state;
  }
  Parts parts = evaluateParts(cell, metals, state);
  double target;
  if (findTarget(cell, metals, state, parts, target))
  {
    relaxTo(target, cell, metals, state, parts);
  }
  state.pressure = cell.fraction[0] * parts.pressure[0] + cell.fraction[1] * parts.pressure[1];
  averageModuli(cell, metals, parts, state);
  return state;
}
}
