#include "Extract/FractionInterfaces.h"

#include "Extract/CellCutter.h"
#include "Extract/CorrectVolumes.h"
#include "Extract/Distances.h"
#include "Extract/VolumeReport.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

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

Interfaces makeSurfaces(const CellComplex& complex, const MaterialValues& values,
  const std::vector<std::uint8_t>& winners, const Boundary& boundary, Progress& progress)
{
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
}

ExtractedInterfaces extractFromFractions(const Simulation& simulation, const ExtractOptions& options,
  const GridTopology& topology, const Boundary& boundary, Progress& progress)
{
  const Fractions fractions(simulation, topology);
  ExtractedInterfaces result;
  const MixedRegion region(
    topology, fractions, options.minimumVolumeFraction, boundary.cellsAtOutside(progress), progress);
  MaterialValues values = makeMaterialValues(region.complex, fractions, progress);
  if (!fractions.atPoints())
  {
    turnIntoDistances(region, values, progress);
    keepInterfacesInside(region, values, progress);
    if (options.volumeCorrection)
    {
      result.smearing = correctVolumes(region, options, values, progress);
    }
  }
  const std::vector<std::uint8_t> winners = findWinners(region.complex, values);
  result.interfaces = makeSurfaces(region.complex, values, winners, boundary, progress);
  reportVolumes(region, values, winners, result, progress);
  return result;
}
}
