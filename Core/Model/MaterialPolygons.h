#pragma once

#include "Geometry/SharedPoints.h"
#include "Model/Representation.h"

#include <vector>

namespace strata
{
/// Convex planar polygons, each within one material and one tetrahedron. Points are shared between polygons
/// of one material and never across materials, so that a field's jump stays sharp.
struct MaterialPolygons
{
  Buffer<double> points;             ///< 3 per point
  Buffer<std::int64_t> offsets;      ///< polygon p: corners[offsets[p]] .. corners[offsets[p + 1]]
  Buffer<std::int64_t> corners;      ///< turned as the stage that made them says
  Buffer<std::int32_t> material;     ///< one per polygon
  Buffer<std::int64_t> tetrahedron;  ///< one per polygon: the cell it was cut from
  std::vector<Buffer<float>> values; ///< [field], components interleaved, one tuple per point
};

/// Polygons of some cells before their points are shared. A corner's owner is the polygon's material; polygons that
/// share no points with others add multiples of MaterialSet::capacity to it.
struct PolygonUses
{
  std::vector<PointUse> corners;
  std::vector<std::int64_t> ends; ///< one per polygon: end of its corners
  std::vector<std::int32_t> material;
  std::vector<Index> cell;
};

/// The polygons of several runs of cells, in their order.
PolygonUses joinPolygons(const std::vector<PolygonUses>& blocks);

/// Makes each point once, and interpolates positions and the fields of the polygons' materials.
MaterialPolygons sharePolygons(const Representation& representation, const PolygonUses& uses);
}
