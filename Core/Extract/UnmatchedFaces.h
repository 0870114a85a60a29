#pragma once

#include "Extract/SplitEdges.h"

namespace strata
{
/// The faces of visible cells without a neighbour that don't lie in the sides of the box round the grid, ascending by
/// cell and face. Cheap where there are few: faces are told apart by sums of random numbers per corner.
std::vector<UnmatchedFace> findUnmatchedFaces(const GridTopology& topology, Progress& progress);
}
