#include "Measure/RepresentedRegions.h"

#include "Measure/CellRegions.h"
#include "Measure/FaceJumps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace strata
{
namespace
{
/// Cells whose volumes are summed together, in their order: the result doesn't depend on the number of threads.
constexpr Index cellsPerBlock = 1024;
constexpr Index blocksPerBatch = 256;

void addBlock(const Representation& representation, const std::vector<const float*>& density, Index begin, Index end,
  RepresentedRegions& sums)
{
  CellRegions regions(representation);
  for (Index cell = begin; cell < end; ++cell)
  {
    regions.divide(cell);
    for (const MaterialId m : regions.materials())
    {
      const double volume = regions.volume(m);
      sums.volumes[m.value] += volume;
      if (volume > 0.0 && !density.empty() && density[m.value])
      {
        sums.masses[m.value] += regions.integral(m, density[m.value]);
      }
    }
    for (const CellRegions::Border& border : regions.borders())
    {
      addPolygon(sums.surfaces[orderedPair(border.below, border.above)], border.corners);
    }
  }
}

RepresentedRegions noRegions(std::size_t materialCount)
{
  return { {}, std::vector<double>(materialCount, 0.0), std::vector<double>(materialCount, 0.0) };
}

void append(PairSurfaces& all, const PairSurfaces& part)
{
  for (const auto& [pair, soup] : part)
  {
    std::vector<std::array<Vector, 3>>& triangles = all[pair].triangles;
    triangles.insert(triangles.end(), soup.triangles.begin(), soup.triangles.end());
  }
}
}

void addPolygon(TriangleSoup& soup, const std::vector<Vector>& corners)
{
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    soup.triangles.push_back({ corners[0], corners[i], corners[i + 1] });
  }
}

RepresentedRegions representedRegions(
  const Representation& representation, const std::vector<const float*>& density, Progress& progress)
{
  RepresentedRegions total = noRegions(representation.materials.size());
  const Index blockCount = (representation.cellCount + cellsPerBlock - 1) / cellsPerBlock;
  for (Index batch = 0; batch < blockCount; batch += blocksPerBatch)
  {
    progress.update(static_cast<double>(batch) / static_cast<double>(blockCount));
    const Index blocks = std::min(blocksPerBatch, blockCount - batch);
    std::vector<RepresentedRegions> parts(static_cast<std::size_t>(blocks), noRegions(representation.materials.size()));
    tbb::parallel_for(Index{ 0 }, blocks, [&](Index block) {
      progress.check();
      const Index begin = (batch + block) * cellsPerBlock;
      const Index end = std::min(begin + cellsPerBlock, representation.cellCount);
      addBlock(representation, density, begin, end, parts[static_cast<std::size_t>(block)]);
    });
    for (const RepresentedRegions& part : parts)
    {
      append(total.surfaces, part.surfaces);
      std::transform(
        total.volumes.begin(), total.volumes.end(), part.volumes.begin(), total.volumes.begin(), std::plus<double>());
      std::transform(
        total.masses.begin(), total.masses.end(), part.masses.begin(), total.masses.begin(), std::plus<double>());
    }
  }
  append(total.surfaces, surfacesOnFaces(representation, progress));
  for (std::size_t m = 0; m < representation.materials.size(); ++m)
  {
    if (density.empty() || !density[m])
    {
      total.masses[m] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return total;
}
}
