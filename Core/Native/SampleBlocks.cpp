#include "Native/SampleBlocks.h"

#include "Geometry/Box.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
constexpr Index blockSize = 8;

template<typename Visit>
void forEachSample(const SampleLattice& lattice, const SampleLattice::Position& begin,
  const SampleLattice::Position& end, const Visit& visit)
{
  for (Index k = begin[2]; k < end[2]; ++k)
  {
    for (Index j = begin[1]; j < end[1]; ++j)
    {
      for (Index i = begin[0]; i < end[0]; ++i)
      {
        visit(lattice.index({ i, j, k }));
      }
    }
  }
}
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
    const Range range = samplesOf(lattice, block);
    MaterialSet& set = sets_[static_cast<std::size_t>(block)];
    forEachSample(lattice, range.begin, range.end, [&](Index sample) { set = set | materials[sample]; });
  });
}

SampleBlocks::Range SampleBlocks::samplesOf(const SampleLattice& lattice, Index block) const
{
  Range result;
  const SampleLattice::Position position = { block % counts_[0], (block / counts_[0]) % counts_[1],
    block / (counts_[0] * counts_[1]) };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    result.begin[axis] = blockSize * position[axis];
    result.end[axis] = std::min(result.begin[axis] + blockSize, lattice.count(static_cast<int>(axis)));
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
      const Range range = samplesOf(lattice, static_cast<Index>(block));
      Box box;
      box.add(lattice.point(range.begin));
      box.add(lattice.point({ range.end[0] - 1, range.end[1] - 1, range.end[2] - 1 }));
      blocks.emplace_back(box.squaredDistance(point), static_cast<Index>(block));
    }
  }
  const auto farther = [](const auto& a, const auto& b) { return b < a; };
  std::make_heap(blocks.begin(), blocks.end(), farther);
  std::pair<double, Index> best(std::numeric_limits<double>::infinity(), -1);
  while (!blocks.empty() && blocks.front().first <= best.first)
  {
    const Range range = samplesOf(lattice, blocks.front().second);
    forEachSample(lattice, range.begin, range.end, [&](Index sample) {
      if (materials[sample].contains(m))
      {
        best = std::min(best, { (lattice.point(lattice.position(sample)) - point).squaredNorm(), sample });
      }
    });
    std::pop_heap(blocks.begin(), blocks.end(), farther);
    blocks.pop_back();
  }
  return best.second;
}
}
