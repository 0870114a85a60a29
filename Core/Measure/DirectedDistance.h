#pragma once

#include "Geometry/TriangleTree.h"
#include "Measure/Measure.h"
#include "Model/Progress.h"

#include <array>
#include <vector>

namespace strata
{
/// The largest distance from a point of `from` to the closest point of `to`, within an interval not wider than
/// `tolerance` (data's length unit), by best-first branch and bound over pieces of `from`.
///
/// Infinite if `to` alone is empty, 0 if `from` is. The interval is widened by the rounding of the arithmetic. After
/// `mostBisections` bisections the search stops and the interval, still valid, may be wider than asked for.
DistanceInterval directedDistance(const std::vector<std::array<Vector, 3>>& from, const TriangleTree& to,
  double tolerance, Progress& progress, std::int64_t mostBisections = std::int64_t{ 1 } << 22);
}
