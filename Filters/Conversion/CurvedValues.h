#pragma once

#include "Conversion/InputArrays.h"

#include <cstdint>

namespace strata::conversion
{
/// A field at points as one material has it on a grid with curved cells.
struct CurvedValues
{
  ValueArray values;
  /// Cells that meet at a point may have values of their own there, of which the mean is taken: the largest
  /// difference between such values of the material.
  double largestJump = 0.0;
};

/// An array's values at the grid's points, at each the mean over the corners there of cells of a material; over all
/// cells where `materialIds` is empty or none of the material's cells meets the point.
CurvedValues curvedValues(const InputGrid& input, const BlockArrays& arrays,
  const std::vector<std::int32_t>& materialIds, std::int32_t material);

/// How far an array's values in the curved cells may lie from those in their linear pieces, where that is bounded.
double curvedDeviation(const InputGrid& input, const BlockArrays& arrays);
}
