#pragma once

#include "Model/Hierarchy.h"
#include "Model/Mesh.h"

#include <algorithm>
#include <utility>

namespace strata
{
/// Values of a material at a vertex where no cell of the level holds it, but a region of it on a neighbour's face
/// must be closed. Same layout as Hierarchy::values.
struct ExtraValues
{
  VertexId vertex;
  MaterialId material;
  std::vector<float> values;
};

/// A conforming mesh within a hierarchy: the set of diamonds that are split in it, closed under parents.
struct Level
{
  std::vector<std::uint8_t> active; ///< one per diamond of the hierarchy at the time of selection
  Index cellCount = 0;
  std::vector<ExtraValues> extra; ///< by vertex, then material
  Achieved achieved;

  bool isActive(DiamondId id) const
  {
    const auto i = static_cast<std::size_t>(id.value);
    return i < active.size() && active[i] != 0;
  }
  /// The values of a material at a vertex, from the hierarchy or the extra ones; null if there are none.
  const float* valuesOf(const Hierarchy& hierarchy, VertexId vertex, MaterialId m) const
  {
    const float* values = hierarchy.valuesOf(vertex, m);
    if (values || extra.empty())
    {
      return values;
    }
    const auto at = std::lower_bound(extra.begin(), extra.end(), std::make_pair(vertex, m),
      [](const ExtraValues& a, const std::pair<VertexId, MaterialId>& b) {
        return a.vertex < b.first || (a.vertex == b.first && a.material < b.second);
      });
    return at != extra.end() && at->vertex == vertex && at->material == m ? at->values.data() : nullptr;
  }
};
}
