#pragma once

#include "Model/MaterialPolygons.h"
#include "Slice/PlaneFunction.h"
#include "Slice/SliceIndex.h"

namespace strata
{
/// Cuts the cells of a representation by a plane into polygons of the given materials, ascending by cell.
/// Without an index all cells are looked at.
PolygonUses sliceCells(const Representation& representation, const SlicePlane& plane, MaterialSet materials,
  const SliceIndex* index, Progress& progress);
}
