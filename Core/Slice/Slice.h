#pragma once

#include "Model/Progress.h"
#include "Model/Representation.h"

#include <vector>

namespace strata
{
/// The plane { p : normal . (p - origin) = offset }.
struct SlicePlane
{
  Vector origin = Vector::Zero();
  Vector normal = Vector::UnitX();
  double offset = 0.0;
};

/// Convex planar polygons, each within one material and one tetrahedron. Points are shared between polygons
/// of one material and never across materials, so that a field's jump stays sharp.
struct SlicePolygons
{
  Buffer<double> points;             ///< 3 per point
  Buffer<std::int64_t> offsets;      ///< polygon p: corners[offsets[p]] .. corners[offsets[p + 1]]
  Buffer<std::int64_t> corners;      ///< counter-clockwise seen against the normal
  Buffer<std::int32_t> material;     ///< one per polygon
  Buffer<std::int64_t> tetrahedron;  ///< one per polygon: the cell it was cut from
  std::vector<Buffer<float>> values; ///< [field], components interleaved, one tuple per point
};

/// A search structure over a mesh's cells for slicing it again and again; valid while the mesh is unchanged.
class SliceIndex;

/// Cuts a representation by a plane into the polygons of the given materials. Throws InvalidInput for a zero normal.
SlicePolygons slice(const Representation& representation, const SlicePlane& plane, MaterialSet materials,
  const SliceIndex* index, Progress& progress);
}
