#pragma once

#include "Model/CellRows.h"
#include "Model/ErrorBounds.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// Vertices all of whose cells have errors below this part of their bounds are left alone.
constexpr double worthFitting = 0.6;

/// Moves the values at a vertex, one after the other, to where the largest error relative to its bound is smallest over
/// the cells round it: `star`, positions in `cells` and `rows`.
void fitVertex(Hierarchy& values, const std::vector<CellId>& cells, const std::vector<CellRows>& rows,
  const ErrorBounds& bounds, VertexId vertex, const std::vector<std::size_t>& star);
}
