#pragma once

#include "Geometry/CutTetrahedron.h"

#include <array>
#include <vector>

namespace strata
{
/// A polygon's point with the lowest name, from which it is triangulated: the same from both of its sides.
/// Returns a position in cut.loops().
int fanCentre(const TetrahedronCut& cut, const TetrahedronCut::Face& face);

/// Tetrahedra that fill a function's region, as points of the cut: the cone from the region's point with the lowest
/// name over the fans of the faces away from it. Positively oriented if the given corners are; adjacent pieces of all
/// regions match, also across tetrahedra. Pieces of less than 1e-15 of the volume are left out.
void fillRegion(const TetrahedronCut& cut, int function, std::vector<std::array<int, 4>>& result);
}
