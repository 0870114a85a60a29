#include "PreparedInterfaces.h"

namespace strata
{
std::shared_ptr<const InterfaceGeometry> PreparedInterfaces::geometry(const NativeData& native, DistanceMethod method)
{
  // Without interfaces, the samples of the fields say which material fills the box.
  if (!geometry_ || method_ != method || interfaces_.triangleCount() == 0)
  {
    geometry_ = std::make_shared<InterfaceGeometry>(interfaces_, native, method);
    method_ = method;
  }
  return geometry_;
}

const InterfaceTrees& PreparedInterfaces::trees()
{
  if (!trees_)
  {
    trees_ = std::make_unique<InterfaceTrees>(interfaces_);
  }
  return *trees_;
}
}
