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
  /// Whether a cell is too coarse and not on the maximum level.
  bool mustSplit(const Hierarchy& hierarchy, CellId cell, double scale) const
  {
    return maySplit(hierarchy.cell(cell)) && exceeds(hierarchy, cell, scale);
  }
  /// Whether a cell is not on the maximum level.
  bool maySplit(const HierarchyCell& cell) const { return cell.level < maximumLevel_; }
  /// The interface error that a cell may have; infinite where nobody is interested.
  double interfaceBound(const Hierarchy& hierarchy, CellId cell) const;

private:
  bool exceeds(const Hierarchy& hierarchy, CellId cell, double scale) const
  {
    if (scale != 1.0 || !everything_)
    {
      return static_cast<double>(ratio(hierarchy, cell)) > scale;
    }
    // The same without divisions: a ratio is greater than 1 exactly if an error is greater than its bound.
    bool result = static_cast<double>(hierarchy.interfaceError(cell)) > bounds_.interfaceError;
    for (std::size_t f = 0; f < bounds_.fieldErrors.size(); ++f)
    {
      result = result || static_cast<double>(hierarchy.fieldError(cell, f)) > bounds_.fieldErrors[f];
    }
    return result;
  }

  /// What the bounds at a cell become; negative where the cell needs not meet any.
  struct Demand
  {
    double interfaceError;
    double fieldScale;
  };
  Demand demandAt(const Hierarchy& hierarchy, CellId cell) const;

  ErrorBounds bounds_;
  Interest interest_;
  bool everything_;
  int maximumLevel_;
};
}
