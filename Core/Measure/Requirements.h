#pragma once

#include "Measure/Measure.h"

namespace strata
{
/// Throws InvalidInput, naming the thing and its value, unless the representation is complete and stands for a data set
/// with the same materials.
void requireMeasurable(const Representation& representation, const NativeData& native, const Interfaces& original,
  const OriginalVolumes& volumes);
}
