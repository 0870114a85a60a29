#pragma once

#include "Build/BuildOptions.h"
#include "Model/Mesh.h"
#include "Select/SelectOptions.h"

#include <functional>

namespace strata
{
/// Throws InvalidInput, naming the bound, unless all bounds are positive and there is one for each field, and unless
/// the base mesh has no more cells than allowed.
void check(const SelectOptions& options, const std::vector<Field>& fields, const BuildOptions& build);

/// The bounds down to which saturated and accumulated errors look: never looser than the level's own.
ErrorBounds finestOf(const SelectOptions& select);

/// The bounds, but for those that no refinement could meet: values are stored as floats.
ErrorBounds attainable(ErrorBounds bounds, const NativeData& native);

ErrorBounds scaled(ErrorBounds bounds, double scale);

/// The smallest scale of at least one at which fits(scale) holds, which must be monotone and hold at the
/// largest float.
double smallestScale(const std::function<bool(double)>& fits);

bool meets(const Achieved& achieved, const ErrorBounds& bounds);

/// Says why a level that refinement took for finished does not meet the bounds.
std::string reasonOf(const Achieved& achieved, const ErrorBounds& attainableBounds, bool everywhere);
}
