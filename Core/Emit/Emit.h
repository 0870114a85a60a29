#pragma once

#include "Model/Level.h"
#include "Model/Mesh.h"
#include "Model/Progress.h"

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
/// the order of their first use, whatever the order in which the hierarchy was built.
Mesh emitMesh(const Hierarchy& hierarchy, const Level& level, const EmitOptions& options, Progress& progress);
}
