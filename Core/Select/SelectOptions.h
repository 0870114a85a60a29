#pragma once

#include "Build/BuildOptions.h"

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
  /// Bounds of the hierarchy that saturated and accumulated errors look down into; never looser than `bounds`.
  ErrorBounds finestBounds;
  Index maximumNumberOfCells = std::numeric_limits<Index>::max();
};
}
