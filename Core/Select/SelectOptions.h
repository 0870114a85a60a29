#pragma once

#include "Model/ErrorBounds.h"
#include "Model/Ids.h"
#include "Select/Interest.h"

#include <cstdint>
#include <limits>

namespace strata
{
/// How a cell's error follows from its own and its descendants' (design 3.5).
enum class ErrorMethod : std::uint8_t
{
  Direct,     ///< each cell's own error
  Saturated,  ///< the largest over the diamond and all its descendants: nested
  Fitted,     ///< a looser level whose vertex values are fitted until the bounds hold
  Accumulated ///< the paper's equation 1
};

/// What a slider may change without building anew.
struct SelectOptions
{
  ErrorBounds bounds;
  ErrorMethod errorMethod = ErrorMethod::Direct;
  /// How deep saturated and accumulated errors look into the hierarchy; 0 or empty, or looser than `bounds`: no
  /// deeper than `bounds`.
  ErrorBounds finestBounds;
  /// What the level is refined for; used by the direct method, whatever `errorMethod` says, if it is not everything.
  Interest interest;
  Index maximumNumberOfCells = std::numeric_limits<Index>::max();
};
}
