#pragma once

#include "Model/Progress.h"
#include "Native/SampleMaterials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace strata
{
/// Smallest and largest of some numbers.
struct Range
{
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();

  void add(double value)
  {
    lower = value < lower ? value : lower;
    upper = value > upper ? value : upper;
  }
  void add(const Range& other)
  {
    lower = other.lower < lower ? other.lower : lower;
    upper = other.upper > upper ? other.upper : upper;
  }
  double size() const { return upper > lower ? upper - lower : 0.0; }
  /// The largest absolute value; 0 where there are no numbers.
  double magnitude() const { return upper < lower ? 0.0 : std::max(std::abs(lower), std::abs(upper)); }
};

/// The ranges of a field over the samples that count.
struct FieldRange
{
  Range length;                              ///< over all materials; of the vector length where there are components
  std::vector<std::vector<Range>> materials; ///< [material][component]
};

/// Finds a field's ranges. Throws InvalidInput for the first sample that counts for a material and at which
/// the material's value is not finite.
FieldRange findRange(
  const SimulationField& field, const Materials& materials, const SampleMaterials& samples, Progress& progress);
}
