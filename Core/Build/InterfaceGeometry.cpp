#include "Build/InterfaceGeometry.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
/// Without interfaces one material fills the box: the one that the first sample counts for, else the first.
MaterialId onlyMaterial(const NativeData& native)
{
  constexpr Index blockSize = 4096;
  std::vector<SampleIndex> ids;
  std::vector<MaterialSet> sets(static_cast<std::size_t>(blockSize));
  for (Index begin = 0; begin < static_cast<Index>(native.sampleCount()); begin += blockSize)
  {
    ids.clear();
    for (Index i = begin; i < std::min<Index>(begin + blockSize, native.sampleCount()); ++i)
    {
      ids.push_back(static_cast<SampleIndex>(i));
    }
    native.materialsAt(ids.data(), static_cast<Index>(ids.size()), sets.data());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      if (!sets[i].empty())
      {
        return sets[i].first();
      }
    }
  }
  return MaterialId(0);
}
}

InterfaceGeometry::InterfaceGeometry(const Interfaces& interfaces, const NativeData& native, DistanceMethod method) :
  elements(interfaces), regions(native.materials().size())
{
  const bool anyInterface = interfaces.triangleCount() > 0;
  const MaterialId only = anyInterface ? MaterialId() : onlyMaterial(native);
  tbb::parallel_for(std::size_t{ 0 }, regions.size(), [&](std::size_t m) {
    const MaterialId material(static_cast<Index>(m));
    regions[m] = std::make_unique<RegionBoundary>(interfaces, material, native.box(), method, material == only);
  });
}
}
