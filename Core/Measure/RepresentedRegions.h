#pragma once

#include "Measure/Measure.h"

#include <map>

namespace strata
{
/// Two materials, the lower one first.
using MaterialPair = std::pair<MaterialId, MaterialId>;

inline MaterialPair orderedPair(MaterialId a, MaterialId b)
{
  return a < b ? MaterialPair(a, b) : MaterialPair(b, a);
}

using PairSurfaces = std::map<MaterialPair, TriangleSoup>;

/// What a representation says of its materials' regions.
struct RepresentedRegions
{
  PairSurfaces surfaces;       ///< between each pair of materials that touch
  std::vector<double> volumes; ///< one per material, exact up to rounding
  std::vector<double> masses;  ///< integrals of the density; NaN where a region has no values
};

/// Finds the regions of the materials in all cells, exactly: where each distance is the smallest. Surfaces lie within
/// cells, and on faces where the cells on both sides say different materials.
/// `density`: values per vertex, one array per material (null: none); empty if there is no density.
RepresentedRegions representedRegions(
  const Representation& representation, const std::vector<const float*>& density, Progress& progress);

/// Adds the triangles of a convex polygon.
void addPolygon(TriangleSoup& soup, const std::vector<Vector>& corners);
}
