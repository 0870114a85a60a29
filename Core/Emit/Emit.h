#pragma once

#include "Emit/LevelCells.h"
#include "Model/Mesh.h"

namespace strata
{
/// Which optional arrays an emitted mesh carries.
struct EmitOptions
{
  bool distances = true; ///< distance_<m>; without them the mesh can't be sliced sharply
  bool perMaterialValues = true;
  bool ghosts = true;
};

/// Writes a level of a hierarchy as a mesh (design 1). Cells come in the order of the bisection trees, vertices in
/// the order of their first use, whatever the order in which the hierarchy was built. `cells` are those of the level.
Mesh emitMesh(
  const Hierarchy& hierarchy, const Level& level, LevelCells&& cells, const EmitOptions& options, Progress& progress);
}
