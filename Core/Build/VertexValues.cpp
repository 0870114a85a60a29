#include "Build/VertexValues.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

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

VertexValues::VertexValues(const NativeData& native, const Interfaces& interfaces, const BuildOptions& options) :
  native_(native), ghostMethod_(options.ghostMethod)
{
  const bool anyInterface = interfaces.triangleCount() > 0;
  const MaterialId only = anyInterface ? MaterialId() : onlyMaterial(native);
  regions_.resize(native.materials().size());
  tbb::parallel_for(std::size_t{ 0 }, regions_.size(), [&](std::size_t m) {
    const MaterialId material(static_cast<Index>(m));
    regions_[m] =
      std::make_unique<RegionBoundary>(interfaces, material, native.box(), options.distanceMethod, material == only);
  });
}

void VertexValues::evaluate(const Vector& point, MaterialSet materials, float* result) const
{
  const auto components = static_cast<std::size_t>(native_.componentCount());
  std::vector<double> fields(components);
  for (const MaterialId m : materials)
  {
    const auto index = static_cast<std::size_t>(m.value);
    // In a cell that one material fills, there is nothing to measure.
    const RegionPoint where = materials.size() == 1 ? RegionPoint{ true, 0.0, point } : regions_[index]->locate(point);
    *result++ = static_cast<float>(where.distance);
    if (native_.materials()[index].hasFields)
    {
      native_.evaluate(m, point, where.inside, where.closest, ghostMethod_, fields.data());
    }
    else
    {
      std::fill(fields.begin(), fields.end(), std::numeric_limits<double>::quiet_NaN());
    }
    result =
      std::transform(fields.begin(), fields.end(), result, [](double value) { return static_cast<float>(value); });
  }
}
}
