#include "Build/VertexValues.h"

#include <algorithm>
#include <limits>

namespace strata
{
VertexValues::VertexValues(
  const NativeData& native, std::shared_ptr<const InterfaceGeometry> interfaces, GhostMethod ghostMethod) :
  native_(native),
  ghostMethod_(ghostMethod), interfaces_(std::move(interfaces))
{}

void VertexValues::evaluate(const Vector& point, MaterialSet materials, float* result) const
{
  const auto components = static_cast<std::size_t>(native_.componentCount());
  std::vector<double> fields(components);
  for (const MaterialId m : materials)
  {
    const auto index = static_cast<std::size_t>(m.value);
    // In a cell that one material fills, there is nothing to measure.
    const RegionPoint where =
      materials.size() == 1 ? RegionPoint{ true, 0.0, point } : interfaces_->regions[index]->locate(point);
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
