#pragma once

#include "Model/Progress.h"
#include "Model/Representation.h"

namespace strata
{
/// A representation's answer at points.
struct Samples
{
  Buffer<std::int32_t> material;     ///< -1 outside the representation's box
  Buffer<std::uint8_t> outside;      ///< 1 outside the representation's box
  Buffer<std::int64_t> cell;         ///< the cell that holds the point, -1 outside
  std::vector<Buffer<float>> values; ///< [field], the material's value there; NaN without one
};

/// Evaluates a representation at points (3 coordinates each).
Samples sample(const Representation& representation, const double* points, Index count, Progress& progress);
}
