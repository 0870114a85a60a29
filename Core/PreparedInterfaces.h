#pragma once

#include "Build/InterfaceGeometry.h"
#include "Certify/InterfaceTrees.h"

namespace strata
{
/// Original interfaces, and what is made of them when it is first asked for. Nothing here depends on fields, so that
/// time steps or choices in which fields alone change share it.
class PreparedInterfaces
{
public:
  explicit PreparedInterfaces(Interfaces interfaces) : interfaces_(std::move(interfaces)) {}

  /// For a build on `native`, whose grid and materials must be the same at each call.
  std::shared_ptr<const InterfaceGeometry> geometry(const NativeData& native, DistanceMethod method);
  /// For certified distances.
  const InterfaceTrees& trees();

private:
  Interfaces interfaces_;
  std::shared_ptr<const InterfaceGeometry> geometry_;
  DistanceMethod method_ = DistanceMethod::ClosestPoint; ///< of geometry_
  std::unique_ptr<InterfaceTrees> trees_;
};
}
