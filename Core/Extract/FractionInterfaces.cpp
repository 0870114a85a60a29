#include "Extract/FractionInterfaces.h"

#include "Extract/CellCutter.h"
#include "Extract/CorrectVolumes.h"
#include "Extract/Distances.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr std::int32_t blockSize = 512;

std::vector<std::uint8_t> findWinners(const CellComplex& complex, const MaterialValues& values)
{
  std::vector<std::uint8_t> winners(static_cast<std::size_t>(complex.vertexCount()));
  tbb::parallel_for(std::int32_t{ 0 }, complex.vertexCount(), [&](std::int32_t v) { winners[v] = values.winner(v); });
  return winners;
}

/// Flags the faces of a complex that are interfaces to the outside.
std::vector<std::uint8_t> findFacesOutside(const CellComplex& complex, const Boundary& boundary)
{
  if (!boundary.outside())
  {
    return {};
  }
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(complex.faceCount()), 0);
  tbb::parallel_for(std::int32_t{ 0 }, complex.faceCount(), [&](std::int32_t f) {
    if (complex.faceCells[f][1] < 0)
    {
      std::vector<Vector> corners;
      for (std::int32_t i = complex.faceStart[f]; i < complex.faceStart[f + 1]; ++i)
      {
        corners.push_back(complex.positions[complex.faceCorners[i]]);
      }
      flags[f] = boundary.inSideOfBox(corners) ? 0 : 1;
    }
  });
  return flags;
}

Interfaces makeSurfaces(
  const CellComplex& complex, const MaterialValues& values, const Boundary& boundary, Progress& progress)
{
  const std::vector<std::uint8_t> winners = findWinners(complex, values);
  const std::vector<std::uint8_t> facesOutside = findFacesOutside(complex, boundary);
  const std::int32_t blockCount = (complex.cellCount() + blockSize - 1) / blockSize;
  std::vector<SurfacePatch> patches(static_cast<std::size_t>(blockCount));
  tbb::enumerable_thread_specific<CellCutter> cutters([&] { return CellCutter(complex, values, winners); });
  tbb::parallel_for(std::int32_t{ 0 }, blockCount, [&](std::int32_t b) {
    progress.check();
    CellCutter& cutter = cutters.local();
    for (std::int32_t cell = b * blockSize; cell < std::min((b + 1) * blockSize, complex.cellCount()); ++cell)
    {
      if (!facesOutside.empty() || cutter.only(cell) == CellCutter::several)
      {
        cutter.addInterfaces(cell, facesOutside, boundary.outside().value_or(0), patches[b]);
      }
    }
  });
  return joinPatches(patches, progress);
}

/// Reconstructed volume of each material in the cells of a complex: [cell * materials + material].
std::vector<double> measureVolumes(
  const CellComplex& complex, const MaterialValues& values, std::size_t materialCount, Progress& progress)
{
  const std::vector<std::uint8_t> winners = findWinners(complex, values);
  std::vector<double> volumes(static_cast<std::size_t>(complex.cellCount()) * materialCount, 0.0);
  tbb::enumerable_thread_specific<CellCutter> cutters([&] { return CellCutter(complex, values, winners); });
  const std::int32_t blockCount = (complex.cellCount() + blockSize - 1) / blockSize;
  tbb::parallel_for(std::int32_t{ 0 }, blockCount, [&](std::int32_t b) {
    progress.check();
    CellCutter::Regions regions;
    for (std::int32_t cell = b * blockSize; cell < std::min((b + 1) * blockSize, complex.cellCount()); ++cell)
    {
      cutters.local().volumes(cell, regions);
      for (std::size_t i = 0; i < regions.materials.size(); ++i)
      {
        volumes[static_cast<std::size_t>(cell) * materialCount + regions.materials[i]] = regions.volumes[i];
      }
    }
  });
  return volumes;
}

/// Compares the reconstructed volumes with the given ones, cell by cell.
void report(const Fractions& fractions, const GridTopology& topology, const MixedCells& mixed,
  const std::vector<double>& reconstructed, ExtractedInterfaces& result)
{
  const std::size_t materialCount = result.volumes.size();
  result.cellVolumeErrors.assign(
    materialCount, std::vector<double>(static_cast<std::size_t>(topology.cellCount()), 0.0));
  std::vector<Index> mixedCount(materialCount, 0);
  std::vector<Share> shares;
  std::size_t local = 0;
  for (Index cell = 0; cell < topology.cellCount(); ++cell)
  {
    if (topology.hidden(cell))
    {
      continue;
    }
    fractions.ofCell(cell, shares);
    const double volume = topology.volume(cell);
    std::vector<double> difference(materialCount, 0.0);
    for (const Share& share : shares)
    {
      result.volumes[share.material].given += share.value * volume;
      difference[share.material] -= share.value * volume;
    }
    if (local < mixed.cells.size() && mixed.cells[local] == cell)
    {
      for (std::size_t m = 0; m < materialCount; ++m)
      {
        result.volumes[m].reconstructed += reconstructed[local * materialCount + m];
        difference[m] += reconstructed[local * materialCount + m];
      }
      ++local;
    }
    else if (mixed.dominant[cell] != MixedCells::none)
    {
      result.volumes[mixed.dominant[cell]].reconstructed += volume;
      difference[mixed.dominant[cell]] += volume;
    }
    for (std::size_t m = 0; m < materialCount; ++m)
    {
      VolumeReport& volumes = result.volumes[m];
      result.cellVolumeErrors[m][cell] = difference[m];
      volumes.largestError = std::max(volumes.largestError, std::abs(difference[m]));
      volumes.meanError += std::abs(difference[m]);
      mixedCount[m] += shares.size() > 1 ? 1 : 0;
    }
  }
  for (std::size_t m = 0; m < materialCount; ++m)
  {
    result.volumes[m].meanError /= static_cast<double>(std::max<Index>(mixedCount[m], 1));
  }
}
}

ExtractedInterfaces extractFromFractions(const Simulation& simulation, const ExtractOptions& options,
  const GridTopology& topology, const Boundary& boundary, Progress& progress)
{
  const Fractions fractions(simulation, topology);
  const MixedCells mixed =
    findMixedCells(fractions, topology, options.minimumVolumeFraction, boundary.cellsAtOutside(progress), progress);
  const CellComplex complex = makeCellComplex(topology, mixed.cells, progress);
  MaterialValues values = makeMaterialValues(complex, fractions, progress);
  if (!fractions.atPoints() && !getenv("XNODIST")) turnIntoDistances(complex, topology, fractions, values, progress);
  if (options.volumeCorrection && !fractions.atPoints())
  {
    correctVolumes(complex, topology, fractions, options.minimumVolumeFraction, values, progress);
  }
  ExtractedInterfaces result;
  result.volumes.resize(simulation.materials.size());
  result.interfaces = makeSurfaces(complex, values, boundary, progress);
  report(fractions, topology, mixed, measureVolumes(complex, values, simulation.materials.size(), progress), result);
  return result;
}
}
