#pragma once

#include "Geometry/TetrahedronLocator.h"
#include "Measure/Measure.h"

namespace strata
{
/// Errors of all fields of all materials over the native samples that count for them; one report for each field and
/// material with at least one sample. Fields that the representation lacks are left out.
std::vector<FieldErrorReport> measureFields(const Representation& representation, const NativeData& native,
  const TetrahedronLocator& locator, Progress& progress);
}
