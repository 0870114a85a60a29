#pragma once

#include "Emit/LevelCells.h"

namespace strata
{
/// A material that a vertex of a level lacks.
struct MissingMaterial
{
  VertexId vertex;
  std::int64_t number; ///< of the vertex in LevelCells
  MaterialId material;
};

/// Materials that win on a face of a cell whose other corner knows nothing of them: near junctions a cell may touch
/// a region that none of its elements belongs to. Without them the region would end at the face. The result comes
/// by vertex, then material. Adding the materials can make others missing, in cells round the same vertices: to look at
/// those alone, mark their numbers in `changed`; if it is empty, all cells are looked at.
std::vector<MissingMaterial> missingMaterials(const Hierarchy& hierarchy, const Level& level, const LevelCells& cells,
  const std::vector<std::uint8_t>& changed, Progress& progress);
}
