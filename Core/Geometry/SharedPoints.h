#pragma once

#include "Geometry/CutPoint.h"

#include <cstdint>
#include <vector>

namespace strata
{
/// A use of a cut's point by a polygon or piece, with an owner: points are shared within one owner only.
struct PointUse
{
  CutPoint point;
  std::int32_t owner = 0;
};

/// Numbers for points, each made once.
struct SharedPoints
{
  std::vector<std::int64_t> numbers;  ///< one per use
  std::vector<std::int64_t> firstUse; ///< one per point
};

/// Gives uses of the same point by the same owner one number, in the order of first uses, whatever the number of
/// threads. Linear in the number of uses.
SharedPoints sharePoints(const std::vector<PointUse>& uses);
}
