#include "Slice/Slice.h"

#include "Model/Errors.h"
#include "Slice/SliceCells.h"

#include <cmath>
#include <string>

namespace strata
{
namespace
{
void checkInput(const Representation& representation, const SlicePlane& plane, const SliceIndex* index)
{
  if (!plane.normal.allFinite() || plane.normal.isZero(0.0))
  {
    throw InvalidInput("the normal of the slice plane is (" + std::to_string(plane.normal[0]) + ", " +
                       std::to_string(plane.normal[1]) + ", " + std::to_string(plane.normal[2]) +
                       "): it has no direction");
  }
  if (!plane.origin.allFinite() || !std::isfinite(plane.offset))
  {
    throw InvalidInput("the origin or the offset of the slice plane is not finite");
  }
  if (index && index->cellCount() != representation.cellCount)
  {
    throw InvalidInput("the slice index was made for " + std::to_string(index->cellCount()) + " cells, not for " +
                       std::to_string(representation.cellCount));
  }
}
}

MaterialPolygons slice(const Representation& representation, const SlicePlane& plane, MaterialSet materials,
  const SliceIndex* index, Progress& progress)
{
  checkInput(representation, plane, index);
  const PolygonUses cells = sliceCells(representation, plane, materials, index, progress);
  progress.check();
  MaterialPolygons result = sharePolygons(representation, cells);
  progress.update(1.0);
  return result;
}
}
