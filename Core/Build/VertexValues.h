#pragma once

#include "Build/InterfaceGeometry.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// Computes the values at vertices: a function of their place and the input alone (design 3.3, 3.4).
class VertexValues
{
public:
  /// `native` must outlive the object.
  VertexValues(const NativeData& native, std::shared_ptr<const InterfaceGeometry> interfaces, GhostMethod ghostMethod);

  /// Writes a vertex's values in the layout of Hierarchy::values. Thread-safe.
  void evaluate(const Vector& point, MaterialSet materials, float* result) const;

private:
  const NativeData& native_;
  GhostMethod ghostMethod_;
  std::shared_ptr<const InterfaceGeometry> interfaces_;
};
}
