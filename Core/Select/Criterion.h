#pragma once

#include "Model/ErrorBounds.h"
#include "Model/Hierarchy.h"
#include "Select/Interest.h"

namespace strata
{
/// Tells which cells of a hierarchy are too coarse.
///
/// All bounds are multiplied by a scale: what is too coarse at one scale is too coarse at any smaller one, so
/// the levels of falling scales are nested (Documentation/Algorithm.md, Levels).
class Criterion
{
public:
  /// Throws InvalidInput for a view that shows nothing.
  Criterion(ErrorBounds bounds, Interest interest, int maximumLevel);

  /// The largest of a cell's errors in units of its bounds, rounded up: at smaller scales the cell is too coarse.
  float ratio(const Hierarchy& hierarchy, CellId cell) const;
  /// Whether a cell of a ratio is too coarse and not on the maximum level.
  bool mustSplit(const HierarchyCell& cell, float ratio, double scale) const
  {
    return static_cast<double>(ratio) > scale && cell.level < maximumLevel_;
  }

private:
  /// What the bounds at a cell become; negative where the cell needs not meet any.
  struct Demand
  {
    double interfaceError;
    double fieldScale;
  };
  Demand demandAt(const Hierarchy& hierarchy, CellId cell) const;

  ErrorBounds bounds_;
  Interest interest_;
  int maximumLevel_;
};
}
