#pragma once

#include "Geometry/SharedPoints.h"
#include "Model/Representation.h"
#include "Slice/PlaneFunction.h"
#include "Slice/SliceIndex.h"

#include <vector>

namespace strata
{
/// Polygons of some cells before their points are shared. A corner's owner is the polygon's material.
struct SlicedCells
{
  std::vector<PointUse> corners;
  std::vector<std::int64_t> ends; ///< one per polygon: end of its corners
  std::vector<std::int32_t> material;
  std::vector<Index> cell;
};

/// Cuts the cells of a representation by a plane into polygons of the given materials, ascending by cell.
/// Without an index all cells are looked at.
SlicedCells sliceCells(const Representation& representation, const SlicePlane& plane, MaterialSet materials,
  const SliceIndex* index, Progress& progress);
}
