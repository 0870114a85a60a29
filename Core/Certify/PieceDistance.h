#pragma once

#include "Certify/InterfaceTrees.h"

namespace strata
{
/// The largest distance from a point of some polygons to the surfaces between their materials: an upper bound. Where
/// it is above a quarter of `limit` it is not above the truth by more than a tenth of `limit` and, if the truth is not
/// above `limit`, not above it either but for a thousandth. As soon as a point is seen to be farther than `limit`, it
/// is the distance of such a point. Infinite for a polygon whose materials have no surface. `rounding` is added: that
/// of one distance.
double largestDistance(
  const std::vector<InterfacePiece>& pieces, const InterfaceTrees& surfaces, double limit, double rounding);

/// The same of the distances from each polygon to the boundaries of both of its materials' regions, whichever materials
/// these touch there. Infinite only where one of the materials has no boundary at all.
double largestDistanceToRegions(
  const std::vector<InterfacePiece>& pieces, const RegionTrees& regions, double limit, double rounding);

/// Rounding of one distance between points whose coordinates are not larger than this.
double distanceRounding(double largestCoordinate);
}
