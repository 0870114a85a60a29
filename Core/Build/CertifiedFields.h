#pragma once

#include "Build/CellElements.h"
#include "Build/CellErrors.h"

namespace strata
{
/// Raises a cell's field errors to upper bounds of |native - represented| over the parts of its native cells that lie
/// in it, for the materials that the cell holds and that all corners of the native cell count for (design 2).
///
/// For scalars on boxes and tetrahedra the bound is the maximum itself but for rounding, which is added; for N
/// components it is at most sqrt(N) times that, where their extremes lie at different points of one edge. On
/// hexahedra it is found by bisection, to within a fifth of the maximum.
void addNativeCellErrors(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const NativeData& native, CellErrors& errors);
}
