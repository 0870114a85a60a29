#pragma once

#include "Build/HierarchyBuilder.h"
#include "Impact.h"
#include "Select/Front.h"

namespace strata::benchmarks
{
/// The direct level of some bounds; extends the hierarchy where it must.
inline Level buildLevel(HierarchyBuilder& builder, const ErrorBounds& bounds, Progress& progress)
{
  const Criterion criterion(bounds, {}, BuildOptions().maximumLevel);
  Front front(builder.hierarchy(), false);
  for (;;)
  {
    const std::vector<DiamondId> missing =
      front.advance(builder.hierarchy(), criterion, 1.0, std::numeric_limits<Index>::max());
    if (missing.empty())
    {
      return front.level(builder.hierarchy());
    }
    builder.split(missing, progress);
  }
}

/// Bounds for levels of very different sizes.
struct NamedBounds
{
  const char* name;
  double interfaceError;
  double density;
};
inline constexpr NamedBounds coarse{ "(0.15,3)", 0.15, 3.0 };
inline constexpr NamedBounds fine{ "(0.05,0.3)", 0.05, 0.3 };
}
