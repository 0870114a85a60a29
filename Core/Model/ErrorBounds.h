#pragma once

#include <vector>

namespace strata
{
/// Largest errors allowed, in the data's units.
struct ErrorBounds
{
  double interfaceError = 0.0;
  std::vector<double> fieldErrors; ///< one per field; infinity where a field sets no bound
};
}
