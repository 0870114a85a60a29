#pragma once

#include "Model/Hierarchy.h"
#include "Model/Mesh.h"

namespace strata
{
/// A conforming mesh within a hierarchy: the set of diamonds that are split in it, closed under parents.
struct Level
{
  std::vector<std::uint8_t> active; ///< one per diamond of the hierarchy at the time of selection
  Index cellCount = 0;
  Achieved achieved;

  bool isActive(DiamondId id) const
  {
    const auto i = static_cast<std::size_t>(id.value);
    return i < active.size() && active[i] != 0;
  }
};
}
