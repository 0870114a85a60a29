#pragma once

#include "Build/CellElements.h"
#include "Model/CellRows.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// A cell's native elements as rows, for the materials that it holds.
CellRows cellRows(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric, const CellElements& elements,
  const NativeData& native, const InterfaceElements& interfaces);

/// Adds the corners of triangles clipped to a cell that is not much larger than they are: there, certified interface
/// errors are largest.
void addClippedCorners(
  const Barycentric& barycentric, const CellElements& elements, const InterfaceElements& interfaces, CellRows& rows);

/// Adds points of native cells in a cell that is not much larger than they are, so that a fit knows what lies between
/// its few samples: the cell's corners and three points of each edge.
void addNativeCellPoints(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const NativeData& native, CellRows& rows);
}
