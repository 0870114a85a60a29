#pragma once

#include "Model/Level.h"
#include "Model/Progress.h"

#include <atomic>

namespace strata
{
/// The materials that the cells round each vertex of a level hold.
class Needs
{
public:
  Needs(const Hierarchy& hierarchy, const Level& level, const std::vector<CellId>& cells);

  MaterialSet at(VertexId vertex) const { return MaterialSet::fromBits(bits_[static_cast<std::size_t>(vertex.value)]); }
  void add(VertexId vertex, MaterialId m)
  {
    bits_[static_cast<std::size_t>(vertex.value)] |= MaterialSet::of(m).bits();
  }
  /// The materials that have values at all corners of a cell: those that a reader of the mesh finds in it.
  MaterialSet atAllCorners(const HierarchyCell& cell) const
  {
    return at(cell.corners[0]) & at(cell.corners[1]) & at(cell.corners[2]) & at(cell.corners[3]);
  }

private:
  std::vector<std::atomic<std::uint64_t>> bits_; ///< [hierarchy vertex]
};

/// A material that a vertex of a level lacks.
struct MissingMaterial
{
  VertexId vertex;
  MaterialId material;
};

/// Materials that win on a face of a cell whose other corner knows nothing of them: near junctions a cell may touch
/// a region that none of its elements belongs to. Without them the region would end at the face. The result's
/// order depends on the level alone; adding the materials can make others missing.
std::vector<MissingMaterial> missingMaterials(const Hierarchy& hierarchy, const Level& level, Progress& progress);
}
