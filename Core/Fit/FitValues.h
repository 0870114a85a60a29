#pragma once

#include "Model/CellRows.h"
#include "Model/ErrorBounds.h"
#include "Model/Hierarchy.h"
#include "Model/Progress.h"

namespace strata
{
/// Moves the values at the vertices of a level, one at a time against the cells round it, so that the largest
/// error relative to its bound falls (design 3.7). `values` is a hierarchy of which `cells` are the level's; only
/// its vertex values change. `rows` has one entry per cell. Vertices whose cells all have errors below a part of
/// their bounds stay as they are, and so do those marked in `fixed` (one entry per vertex of the hierarchy). Vertices
/// that share no cell move at the same time, so the result does not depend on the number of threads.
void fitValues(Hierarchy& values, const std::vector<CellId>& cells, const std::vector<CellRows>& rows,
  const std::vector<std::uint8_t>& fixed, const ErrorBounds& bounds, int sweeps, Progress& progress);
}
