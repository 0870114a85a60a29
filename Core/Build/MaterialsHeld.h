#pragma once

#include "Build/CellElements.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// The materials of a cell's samples and interfaces, or, where it has no interface, the one that is nearest to all of
/// its corners. `allowed` are those of its parent.
MaterialSet materialsHeld(const Hierarchy& hierarchy, CellId cell, const CellElements& elements, MaterialSet allowed,
  const NativeData& native, const InterfaceElements& interfaces);
}
