#pragma once

#include "Model/MaterialPolygons.h"
#include "Model/Progress.h"

namespace strata
{
/// The plane { p : normal . (p - origin) = offset }.
struct SlicePlane
{
  Vector origin = Vector::Zero();
  Vector normal = Vector::UnitX();
  double offset = 0.0;
};

/// A search structure over a mesh's cells for slicing it again and again; valid while the mesh is unchanged.
class SliceIndex;

/// Cuts a representation by a plane into the polygons of the given materials, counter-clockwise seen against the
/// normal. Throws InvalidInput for a zero normal.
MaterialPolygons slice(const Representation& representation, const SlicePlane& plane, MaterialSet materials,
  const SliceIndex* index, Progress& progress);
}
