#pragma once

#include "Build/CellElements.h"
#include "Build/RegionBoundary.h"

namespace strata
{
/// What a build asks of the interfaces, ready for its queries. Where there are interfaces at all, nothing of it depends
/// on fields: on the same grid with the same materials it serves other fields too.
struct InterfaceGeometry
{
  InterfaceGeometry(const Interfaces& interfaces, const NativeData& native, DistanceMethod method);

  InterfaceElements elements;
  std::vector<std::unique_ptr<RegionBoundary>> regions; ///< one per material
};
}
