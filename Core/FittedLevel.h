#pragma once

#include "Build/HierarchyBuilder.h"
#include "Select/Front.h"

namespace strata
{
struct FitOptions
{
  /// The first level meets the bounds times this; fitting brings most of its cells below the bounds.
  double looseness = 3.0;
  /// Passes over the vertices before cells are split, each time.
  int sweeps = 6;
  int maximumLevel = 60;
};

/// A level with values of its own: `values` is the builder's hierarchy but for the values and errors at the level.
struct FittedLevel
{
  Hierarchy values;
  Level level;
};

/// Finds a level that meets the bounds with few cells: takes a looser one, fits the values at its vertices, splits
/// the cells that still fall short, fits again, until all bounds hold (design 3.7). The values belong to the
/// level, never to the hierarchy.
FittedLevel fitLevel(
  HierarchyBuilder& builder, const ErrorBounds& bounds, const FitOptions& options, Progress& progress);
}
