#pragma once

#include "Build/CellElements.h"
#include "Model/CellRows.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// A cell's native elements as rows, for the materials that it holds.
CellRows cellRows(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric, const CellElements& elements,
  const NativeData& native, const InterfaceElements& interfaces);
}
