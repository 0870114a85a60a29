#pragma once

#include "Extract/GridTopology.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace strata
{
/// Triangulates a flat region from the directed edges of its boundary, which run counter-clockwise as seen from the
/// tip of `normal`; it may have holes and several parts. Makes no points and leaves no point on an edge: each of the
/// boundary's edges belongs to one triangle. Nothing if that fails, as where edges cross.
std::optional<std::vector<std::array<Index, 3>>> triangulateRegion(
  const GridTopology& topology, std::vector<std::pair<Index, Index>> boundary, const Vector& normal);
}
