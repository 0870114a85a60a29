#pragma once

#include "Geometry/Box.h"
#include "Model/Progress.h"
#include "Model/Representation.h"
#include "Slice/Slice.h"

#include <algorithm>

#include <vector>

namespace strata
{
/// A mesh's cells in small groups of neighbours with their boxes, so that a plane finds the cells that it may
/// cut without looking at the others. Depends on the points and tetrahedra alone; holds 7 bytes a cell.
class SliceIndex
{
public:
  /// Sorts the cells along a space-filling curve, O(n log n), threaded.
  SliceIndex(const Representation& representation, Progress& progress);

  /// The cells that the plane meets, ascending.
  std::vector<Index> cellsAt(const Representation& representation, const SlicePlane& plane) const;
  /// Whether a vertex lies on the negative side of the plane.
  bool reachesBelow(const Representation& representation, const SlicePlane& plane) const;
  /// Number of cells of the mesh that it was made for.
  Index cellCount() const { return static_cast<Index>(order_.size()); }

private:
  static constexpr Index cellsPerGroup = 16;

  Index groupStart(Index group) const { return std::min(group * cellsPerGroup, cellCount()); }

  std::vector<std::int32_t> order_;
  std::vector<Box> boxes_;
};
}
