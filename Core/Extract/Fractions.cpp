#include "Extract/Fractions.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
constexpr Index blockSize = 4096;

/// Calls visit(i, scratch) for i in [0, count) from several threads.
template<typename Visit>
void forEach(Index count, Progress& progress, const Visit& visit)
{
  tbb::parallel_for(tbb::blocked_range<Index>(0, count, blockSize), [&](const tbb::blocked_range<Index>& range) {
    progress.check();
    std::vector<Index> scratch;
    for (Index i = range.begin(); i < range.end(); ++i)
    {
      visit(i, scratch);
    }
  });
}

/// The largest fraction's material by visible cell, and in `core` the cells that hold another with enough.
void findDominant(const Fractions& fractions, const GridTopology& topology, double minimumFraction,
  std::vector<std::uint8_t>& dominant, std::vector<std::uint8_t>& core, Progress& progress)
{
  tbb::parallel_for(tbb::blocked_range<Index>(0, topology.cellCount(), blockSize), [&](const auto& range) {
    progress.check();
    std::vector<Share> shares;
    for (Index cell = range.begin(); cell < range.end(); ++cell)
    {
      if (topology.hidden(cell))
      {
        continue;
      }
      fractions.ofCell(cell, shares);
      const std::size_t winner = largest(shares);
      for (std::size_t i = 0; i < shares.size(); ++i)
      {
        core[cell] |= i != winner && shares[i].value >= minimumFraction ? 1 : 0;
      }
      dominant[cell] = shares.empty() ? MixedCells::none : shares[winner].material;
    }
  });
}

/// Adds the cells round the points at which the cells (or, for data at points, along whose edges the points) disagree.
void addChanges(const Fractions& fractions, const GridTopology& topology, const std::vector<std::uint8_t>& dominant,
  std::vector<std::uint8_t>& core, Progress& progress)
{
  std::vector<std::uint8_t> pointValue(static_cast<std::size_t>(topology.pointCount()), MixedCells::none);
  forEach(topology.pointCount(), progress, [&](Index point, std::vector<Index>& cells) {
    if (fractions.atPoints())
    {
      std::vector<Share> shares;
      fractions.ofPoint(point, shares);
      pointValue[point] = shares.empty() ? MixedCells::none : shares[largest(shares)].material;
      return;
    }
    topology.cellsAround(point, cells);
    const auto differs = [&](Index cell) { return dominant[cell] != dominant[cells.front()]; };
    if (!cells.empty() && std::none_of(cells.begin(), cells.end(), differs))
    {
      pointValue[point] = dominant[cells.front()];
    }
  });
  forEach(topology.cellCount(), progress, [&](Index cell, std::vector<Index>& corners) {
    topology.corners(cell, corners);
    for (Index corner : corners)
    {
      core[cell] |= !topology.hidden(cell) && pointValue[corner] != dominant[cell] ? 1 : 0;
    }
  });
}

/// Adds the cells that share a point with the chosen ones.
void addRing(const GridTopology& topology, std::vector<std::uint8_t>& chosen, Progress& progress)
{
  std::vector<std::uint8_t> pointFlags(static_cast<std::size_t>(topology.pointCount()), 0);
  forEach(topology.pointCount(), progress, [&](Index point, std::vector<Index>& cells) {
    topology.cellsAround(point, cells);
    for (Index cell : cells)
    {
      pointFlags[point] |= chosen[cell];
    }
  });
  forEach(topology.cellCount(), progress, [&](Index cell, std::vector<Index>& corners) {
    topology.corners(cell, corners);
    for (Index corner : corners)
    {
      chosen[cell] |= !topology.hidden(cell) ? pointFlags[corner] : 0;
    }
  });
}
}

Fractions::Fractions(const Simulation& simulation, const GridTopology& topology) :
  arrays_(simulation.fractions), topology_(topology), atPoints_(simulation.fractionAssociation == Association::Points)
{}

void Fractions::mean(const std::vector<Index>& tuples, std::vector<Share>& result) const
{
  result.clear();
  for (std::size_t m = 0; m < arrays_.size(); ++m)
  {
    double sum = 0.0;
    for (Index tuple : tuples)
    {
      sum += arrays_[m](tuple);
    }
    if (sum > 0.0)
    {
      result.push_back({ static_cast<std::uint8_t>(m), sum / static_cast<double>(tuples.size()) });
    }
  }
}

void Fractions::ofCell(Index cell, std::vector<Share>& result) const
{
  if (atPoints_)
  {
    std::vector<Index> points;
    topology_.centerCorners(cell, points);
    mean(points, result);
    return;
  }
  result.clear();
  for (std::size_t m = 0; m < arrays_.size(); ++m)
  {
    const double value = arrays_[m](cell);
    if (value > 0.0)
    {
      result.push_back({ static_cast<std::uint8_t>(m), value });
    }
  }
}

void Fractions::volumesOfCell(Index cell, double volume, std::vector<Share>& result) const
{
  ofCell(cell, result);
  double sum = 0.0;
  for (const Share& share : result)
  {
    sum += share.value;
  }
  for (Share& share : result)
  {
    share.value *= volume / sum;
  }
}

void Fractions::ofPoint(Index point, std::vector<Share>& result) const
{
  std::vector<Index> tuples{ point };
  if (!atPoints_)
  {
    topology_.cellsAround(point, tuples);
  }
  mean(tuples, result);
}

double valueOf(const std::vector<Share>& shares, std::uint8_t material)
{
  for (const Share& share : shares)
  {
    if (share.material == material)
    {
      return share.value;
    }
  }
  return 0.0;
}

std::size_t largest(const std::vector<Share>& shares)
{
  const auto less = [](const Share& a, const Share& b) { return a.value < b.value; };
  return static_cast<std::size_t>(std::max_element(shares.begin(), shares.end(), less) - shares.begin());
}

MixedCells findMixedCells(const Fractions& fractions, const GridTopology& topology, double minimumFraction,
  const std::vector<std::uint8_t>& also, Progress& progress)
{
  MixedCells result;
  const auto cellCount = static_cast<std::size_t>(topology.cellCount());
  result.dominant.assign(cellCount, MixedCells::none);
  std::vector<std::uint8_t> chosen(cellCount, 0);
  findDominant(fractions, topology, minimumFraction, result.dominant, chosen, progress);
  addChanges(fractions, topology, result.dominant, chosen, progress);
  addRing(topology, chosen, progress);
  for (Index cell = 0; cell < topology.cellCount(); ++cell)
  {
    if (chosen[cell] || (!also.empty() && also[cell]))
    {
      result.cells.push_back(cell);
    }
  }
  return result;
}
}
