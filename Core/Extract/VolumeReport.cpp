#include "Extract/VolumeReport.h"

#include "Extract/ForEach.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr Index blockSize = 4096;

/// The sums over a block of cells; blocks are added up in order, so that the result is always the same.
struct BlockReport
{
  std::vector<VolumeReport> materials;
  Index mixedCells = 0;

  void add(const BlockReport& other)
  {
    for (std::size_t m = 0; m < materials.size(); ++m)
    {
      materials[m].given += other.materials[m].given;
      materials[m].reconstructed += other.materials[m].reconstructed;
      materials[m].meanError += other.materials[m].meanError;
      materials[m].largestError = std::max(materials[m].largestError, other.materials[m].largestError);
    }
    mixedCells += other.mixedCells;
  }
};

/// Measures the regions in the cells of a complex: [cell of the complex].
std::vector<std::vector<Share>> measureRegions(const CellComplex& complex, const MaterialValues& values,
  const std::vector<std::uint8_t>& winners, Progress& progress)
{
  struct Workspace
  {
    CellCutter cutter;
    CellCutter::Regions regions;
  };
  tbb::enumerable_thread_specific<Workspace> workspaces([&] {
    return Workspace{ CellCutter(complex, values, winners), {} };
  });
  std::vector<std::vector<Share>> result(complex.cells.size());
  forEach(complex.cellCount(), progress, [&](std::int32_t c) {
    CellCutter::Regions& regions = workspaces.local().regions;
    workspaces.local().cutter.volumes(c, regions);
    for (std::size_t i = 0; i < regions.materials.size(); ++i)
    {
      result[c].push_back({ regions.materials[i], regions.volumes[i] });
    }
  });
  return result;
}

/// Adds a cell: `regions` are the volumes that its materials got.
void addCell(Index cell, double volume, const std::vector<Share>& shares, const std::vector<Share>& regions,
  BlockReport& block, std::vector<std::vector<double>>& errors)
{
  block.mixedCells += shares.size() > 1 ? 1 : 0;
  for (const Share& region : regions)
  {
    block.materials[region.material].reconstructed += region.value;
    errors[region.material][cell] += region.value;
  }
  for (const Share& share : shares)
  {
    block.materials[share.material].given += share.value * volume;
    errors[share.material][cell] -= share.value * volume;
  }
  const auto take = [&](const std::vector<Share>& list, const std::vector<Share>* counted) {
    for (const Share& share : list)
    {
      const auto same = [&](const Share& other) { return other.material == share.material; };
      if (!counted || std::none_of(counted->begin(), counted->end(), same))
      {
        const double error = std::abs(errors[share.material][cell]);
        block.materials[share.material].meanError += error;
        block.materials[share.material].largestError = std::max(block.materials[share.material].largestError, error);
      }
    }
  };
  take(shares, nullptr);
  take(regions, &shares);
}
}

void reportVolumes(const MixedRegion& region, const MaterialValues& values, const std::vector<std::uint8_t>& winners,
  ExtractedInterfaces& result, Progress& progress)
{
  const GridTopology& topology = region.topology;
  const Fractions& fractions = region.fractions;
  const MixedCells& mixed = region.mixed;
  const auto materialCount = static_cast<std::size_t>(fractions.materialCount());
  const std::vector<std::vector<Share>> regions = measureRegions(region.complex, values, winners, progress);
  result.cellVolumeErrors.assign(
    materialCount, std::vector<double>(static_cast<std::size_t>(topology.cellCount()), 0.0));
  const Index blockCount = (topology.cellCount() + blockSize - 1) / blockSize;
  std::vector<BlockReport> blocks(static_cast<std::size_t>(blockCount));
  tbb::parallel_for(Index{ 0 }, blockCount, [&](Index b) {
    progress.check();
    blocks[b].materials.resize(materialCount);
    std::vector<Share> shares;
    auto local = std::lower_bound(mixed.cells.begin(), mixed.cells.end(), b * blockSize);
    for (Index cell = b * blockSize; cell < std::min((b + 1) * blockSize, topology.cellCount()); ++cell)
    {
      const bool inComplex = local != mixed.cells.end() && *local == cell;
      if (mixed.dominant[cell] != MixedCells::none)
      {
        const double volume = topology.volume(cell);
        fractions.ofCell(cell, shares);
        addCell(cell, volume, shares,
          inComplex ? regions[local - mixed.cells.begin()] : std::vector<Share>{ { mixed.dominant[cell], volume } },
          blocks[b], result.cellVolumeErrors);
      }
      local += inComplex ? 1 : 0;
    }
  });
  BlockReport sum;
  sum.materials.resize(materialCount);
  for (const BlockReport& block : blocks)
  {
    sum.add(block);
  }
  for (VolumeReport& material : sum.materials)
  {
    material.meanError /= static_cast<double>(std::max<Index>(sum.mixedCells, 1));
  }
  result.volumes = std::move(sum.materials);
}
}
