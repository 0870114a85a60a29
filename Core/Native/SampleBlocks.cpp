#include "Native/SampleBlocks.h"

#include "Geometry/Box.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
constexpr Index blockSize = 8;
}

SampleBlocks::SampleBlocks(const SampleLattice& lattice, const SampleMaterials& materials, Progress& progress)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    counts_[static_cast<std::size_t>(axis)] = (lattice.count(axis) + blockSize - 1) / blockSize;
  }
  const Index blockCount = counts_[0] * counts_[1] * counts_[2];
  sets_.resize(static_cast<std::size_t>(blockCount));
  tbb::parallel_for(Index{ 0 }, blockCount, [&](Index block) {
    progress.check();
    const Extent extent = samplesOf(lattice, block);
    MaterialSet& set = sets_[static_cast<std::size_t>(block)];
    forEachPosition(
      extent.first, extent.last, [&](const auto& position) { set = set | materials[lattice.index(position)]; });
  });
}

SampleBlocks::Extent SampleBlocks::samplesOf(const SampleLattice& lattice, Index block) const
{
  Extent result;
  const SampleLattice::Position position = { block % counts_[0], (block / counts_[0]) % counts_[1],
    block / (counts_[0] * counts_[1]) };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    result.first[axis] = blockSize * position[axis];
    result.last[axis] = std::min(result.first[axis] + blockSize, lattice.count(static_cast<int>(axis))) - 1;
  }
  return result;
}

Index SampleBlocks::nearest(
  const SampleLattice& lattice, const SampleMaterials& materials, MaterialId m, const Vector& point) const
{
  std::vector<std::pair<double, Index>> blocks;
  for (std::size_t block = 0; block < sets_.size(); ++block)
  {
    if (sets_[block].contains(m))
    {
      const Extent extent = samplesOf(lattice, static_cast<Index>(block));
      Box box;
      box.add(lattice.point(extent.first));
      box.add(lattice.point(extent.last));
      blocks.emplace_back(box.squaredDistance(point), static_cast<Index>(block));
    }
  }
  const auto farther = [](const auto& a, const auto& b) { return b < a; };
  std::make_heap(blocks.begin(), blocks.end(), farther);
  std::pair<double, Index> best(std::numeric_limits<double>::infinity(), -1);
  while (!blocks.empty() && blocks.front().first <= best.first)
  {
    const Extent extent = samplesOf(lattice, blocks.front().second);
    forEachPosition(extent.first, extent.last, [&](const auto& position) {
      const Index sample = lattice.index(position);
      if (materials[sample].contains(m))
      {
        best = std::min(best, { (lattice.point(position) - point).squaredNorm(), sample });
      }
    });
    std::pop_heap(blocks.begin(), blocks.end(), farther);
    blocks.pop_back();
  }
  return best.second;
}
}
