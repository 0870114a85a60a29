#pragma once

#include "Extract/ReplacedCells.h"
#include "Extract/SplitEdges.h"
#include "Model/Errors.h"

namespace strata
{
/// Makes cells conform that meet finer ones, as at the borders of levels of an octree: an unmatched face that finer
/// unmatched faces of other cells cover becomes those faces, and points that hang on edges become corners of all
/// faces with those edges. The cells keep their shape, up to `hangingTolerance`. Faces may lie in any plane, and
/// meet any number of finer ones; what these leave of a face becomes triangles. Where finer faces neither cover nor
/// leave a region that can be triangulated, the face stays as it is, with a warning.
/// `unmatched` ascends by cell and face. Adds the new cells to `cells`.
void joinHangingNodes(const GridTopology& topology, const std::vector<UnmatchedFace>& unmatched, ReplacedCells& cells,
  Warnings& warnings, Progress& progress);
}
