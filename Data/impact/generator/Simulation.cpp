#include "Simulation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace impact
{
namespace
{
double overlap(double from, double to, double low, double high)
{
  return std::max(0.0, std::min(to, high) - std::max(from, low)) / (to - from);
}

/// The part of a cell at `corner` that a sphere about (0, 0, height) fills; cells it cuts are sampled.
double sphereFraction(const Simulation& simulation, const double corner[3], double height)
{
  const auto& h = simulation.spacing;
  const double squaredRadius = simulation.options.radius * simulation.options.radius;
  double nearest = 0;
  double farthest = 0; // squared distances of the cell's points from the centre
  for (int d = 0; d < 3; ++d)
  {
    const double from = corner[d] - (d == 2 ? height : 0);
    const double to = from + h[d];
    farthest += std::max(from * from, to * to);
    nearest += from > 0 ? from * from : to < 0 ? to * to : 0;
  }
  if (farthest <= squaredRadius)
  {
    return 1;
  }
  if (nearest >= squaredRadius)
  {
    return 0;
  }
  const int samples = 12;
  int inside = 0;
  for (int w = 0; w < samples * samples * samples; ++w)
  {
    const double x = corner[0] + h[0] * (w % samples + 0.5) / samples;
    const double y = corner[1] + h[1] * (w / samples % samples + 0.5) / samples;
    const double z = corner[2] + h[2] * (w / (samples * samples) + 0.5) / samples - height;
    inside += x * x + y * y + z * z < squaredRadius;
  }
  return double(inside) / (samples * samples * samples);
}

double blockFraction(const Simulation& simulation, const double corner[3])
{
  const auto& h = simulation.spacing;
  const Options& options = simulation.options;
  const double fraction = overlap(corner[0], corner[0] + h[0], 0, options.side) *
                          overlap(corner[1], corner[1] + h[1], 0, options.side) *
                          overlap(corner[2], corner[2] + h[2], options.bottom, 0);
  return fraction > 1 - 1e-12 ? 1 : fraction < 1e-12 ? 0 : fraction;
}
}

Simulation::Simulation(const Options& o) :
  options(o), metals{ { findMaterial(o.projectile), findMaterial(o.block) }, o.strength }
{
  for (int d = 0; d < 3; ++d)
  {
    count[d] = coarseCells[d] * options.res;
    spacing[d] = (upperCorner[d] - lowerCorner[d]) / count[d];
  }
  stride = { 1, std::size_t(count[0]), std::size_t(count[0]) * count[1] };
  cells.resize(stride[2] * count[2]);
  for (int k = 0; k < 2; ++k)
  {
    fractions[k].resize(cells.size());
    newFractions[k].resize(cells.size());
  }
}

std::array<double, 3> Simulation::outwardNormal(int which, const std::array<int, 3>& index) const
{
  std::array<double, 3> normal = { 0, 0, 0 };
  for (int w = 0; w < 27; ++w)
  {
    const int di = w % 3 - 1;
    const int dj = w / 3 % 3 - 1;
    const int dk = w / 9 - 1;
    const double fraction = fractions[which][cellAt(std::clamp(index[0] + di, 0, count[0] - 1),
      std::clamp(index[1] + dj, 0, count[1] - 1), std::clamp(index[2] + dk, 0, count[2] - 1))];
    const int weightX = 2 - di * di;
    const int weightY = 2 - dj * dj;
    const int weightZ = 2 - dk * dk;
    normal[0] -= di * weightY * weightZ * fraction;
    normal[1] -= dj * weightX * weightZ * fraction;
    normal[2] -= dk * weightX * weightY * fraction;
  }
  return normal;
}

void setInitialState(Simulation& simulation, double gap)
{
  const auto& count = simulation.count;
  const double height = simulation.options.radius + gap;
#pragma omp parallel for
  for (int k = 0; k < count[2]; ++k)
  {
    for (int row = 0; row < count[0] * count[1]; ++row)
    {
      const int index[3] = { row % count[0], row / count[0], k };
      double corner[3];
      for (int d = 0; d < 3; ++d)
      {
        corner[d] = lowerCorner[d] + index[d] * simulation.spacing[d];
      }
      const std::size_t id = simulation.cellAt(index[0], index[1], k);
      Cell& cell = simulation.cells[id];
      cell.fraction[0] = sphereFraction(simulation, corner, height);
      cell.fraction[1] = blockFraction(simulation, corner);
      for (int m = 0; m < 2; ++m)
      {
        cell.mass[m] = simulation.metals.material[m].density * cell.fraction[m];
      }
      if (cell.fraction[0] > 0)
      {
        cell.velocity[2] = -simulation.options.speed;
      }
      simulation.fractions[0][id] = simulation.newFractions[0][id] = float(cell.fraction[0]);
      simulation.fractions[1][id] = simulation.newFractions[1][id] = float(std::max(0.0, 1 - cell.solid()));
    }
  }
}

void report(const Simulation& simulation, int step, double time, double timeStep)
{
  const double volume = simulation.cellVolume();
  double mass[2] = { 0, 0 };
  double internal = 0, kinetic = 0, momentum = 0, highest = -9, lowest = 9, densest = 0, fastest = 0;
  std::size_t bad = 0;
#pragma omp parallel for reduction(+ : mass[:2], internal, kinetic, momentum, bad) \
  reduction(max : highest, densest, fastest) reduction(min : lowest)
  for (std::size_t i = 0; i < simulation.cells.size(); ++i)
  {
    Cell cell = simulation.cells[i];
    if (cell.totalMass() == 0)
    {
      continue;
    }
    const double pressure = relax(cell, simulation.metals).pressure;
    const double* v = cell.velocity;
    const double squaredSpeed = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    for (int k = 0; k < 2; ++k)
    {
      mass[k] += volume * cell.mass[k];
      internal += volume * cell.energy[k];
      densest = cell.fraction[k] > 1e-3 ? std::max(densest, cell.mass[k] / cell.fraction[k]) : densest;
    }
    kinetic += 0.5 * volume * cell.totalMass() * squaredSpeed;
    momentum += volume * cell.totalMass() * v[2];
    highest = std::max(highest, pressure);
    lowest = std::min(lowest, pressure);
    fastest = std::max(fastest, std::sqrt(squaredSpeed));
    bad += !std::isfinite(cell.totalMass() + squaredSpeed + pressure + cell.deviator[0]) || cell.solid() > 1 + 1e-12;
  }
  std::printf("step %5d t %8.3f dt %.4f  mass %.6f %.5f left %.2e %.2e  E %.4f kin %.4f mom %.3f  "
              "p %.3f..%.3f rho<%.2f v<%.3f bad %zu\n",
    step, time, timeStep, mass[0], mass[1], volume * simulation.lostMass[0], volume * simulation.lostMass[1],
    internal + kinetic, kinetic, momentum, lowest, highest, densest, fastest, bad);
  std::fflush(stdout);
}
}
