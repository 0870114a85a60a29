#pragma once

#include "Build/HierarchyBuilder.h"
#include "Emit/LevelCells.h"

namespace strata
{
/// Gives vertices the materials that win on a face of a cell which holds none of them, so that no region ends at
/// a face. `values` is the builder's hierarchy but for the values at the level's vertices; `cells` are the level's.
void closeRegions(
  const HierarchyBuilder& builder, const Hierarchy& values, Level& level, LevelCells& cells, Progress& progress);
}
