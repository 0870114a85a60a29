#pragma once

#include "Model/ErrorBounds.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// Tells which cells of a hierarchy are too coarse.
///
/// All bounds are multiplied by a scale: what is too coarse at one scale is too coarse at any smaller one, so
/// the levels of falling scales are nested (Documentation/Algorithm.md, Levels).
class Criterion
{
public:
  Criterion(ErrorBounds bounds, int maximumLevel) : bounds_(std::move(bounds)), maximumLevel_(maximumLevel) {}

  bool exceedsBounds(const Hierarchy& hierarchy, CellId cell, double scale) const;
  /// Cells on the maximum level are kept as they are.
  bool mustSplit(const Hierarchy& hierarchy, CellId cell, double scale) const;
  /// The smallest scale at which the cell need not be split.
  double sufficientScale(const Hierarchy& hierarchy, CellId cell) const;

private:
  ErrorBounds bounds_;
  int maximumLevel_;
};
}
