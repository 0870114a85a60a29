#pragma once

#include "Model/Level.h"
#include "Select/SelectOptions.h"

namespace strata
{
/// Selects by errors that never grow from a diamond to its descendants, within the diamonds of `finest`:
/// saturated, a diamond's error is the largest over its cells and all its descendants; accumulated, a cell's is
/// its children's largest plus the change at its split vertex (the paper's equation 1), then saturated over the
/// diamonds. `interfaceErrors`: of each cell, the hierarchy's own or larger ones. Cost proportional to the cells
/// of the hierarchy.
Level selectSaturated(const Hierarchy& hierarchy, const Level& finest, const std::vector<float>& interfaceErrors,
  const ErrorBounds& bounds, bool accumulate);
}
