#pragma once

#include "Build/RegionBoundary.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// Computes the values at vertices: a function of their place and the input alone (design 3.3, 3.4).
class VertexValues
{
public:
  VertexValues(const NativeData& native, const Interfaces& interfaces, const BuildOptions& options);

  /// Writes a vertex's values in the layout of Hierarchy::values. Thread-safe.
  void evaluate(const Vector& point, MaterialSet materials, float* result) const;

private:
  const NativeData& native_;
  GhostMethod ghostMethod_;
  std::vector<std::unique_ptr<RegionBoundary>> regions_; ///< one per material
};
}
