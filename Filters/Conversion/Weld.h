#pragma once

#include "Geometry/Vector.h"
#include "Model/Ids.h"

#include <vector>

namespace strata::conversion
{
/// For each point the lowest index of a point that it coincides with, up to a distance of `tolerance` (its
/// own index if there is none). Points must be finite.
std::vector<Index> weld(const std::vector<Vector>& points, double tolerance);

/// Points that are closer than this part of the box's diagonal are taken as one.
constexpr double weldTolerance = 1e-9;
}
