#include "FittedLevel.h"

#include "Emit/LevelCells.h"
#include "Fit/FitValues.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace strata
{
namespace
{
/// Level, values and rows while the fit goes on.
class Fitting
{
public:
  Fitting(HierarchyBuilder& builder, const ErrorBounds& bounds, const FitOptions& options, Progress& progress) :
    builder_(builder), bounds_(bounds), options_(options), progress_(progress),
    criterion_(bounds, {}, options.maximumLevel), front_(builder.hierarchy(), false)
  {}

  FittedLevel run()
  {
    growTo(options_.looseness);
    takeOverHierarchy();
    for (int round = 1;; ++round)
    {
      collectCells();
      fitValues(values_, cells_, rows_, bounds_, options_.sweeps, progress_);
      measure();
      std::vector<CellId> tooCoarse;
      std::copy_if(cells_.begin(), cells_.end(), std::back_inserter(tooCoarse),
        [&](CellId c) { return criterion_.mustSplit(values_, c, 1.0); });
      if (tooCoarse.empty())
      {
        return { std::move(values_), front_.level(builder_.hierarchy()) };
      }
      split(tooCoarse);
      takeOverHierarchy();
      progress_.update(1.0 - std::exp(-0.2 * round));
    }
  }

private:
  void growTo(double scale)
  {
    for (;;)
    {
      const std::vector<DiamondId> missing =
        front_.advance(builder_.hierarchy(), criterion_, scale, std::numeric_limits<Index>::max());
      if (missing.empty())
      {
        return;
      }
      builder_.split(missing, progress_);
    }
  }

  void split(const std::vector<CellId>& cells)
  {
    for (;;)
    {
      const std::vector<DiamondId> missing = front_.split(builder_.hierarchy(), cells);
      if (missing.empty())
      {
        return;
      }
      builder_.split(missing, progress_);
    }
  }

  /// New cells and vertices come from the hierarchy; fitted values stay.
  void takeOverHierarchy()
  {
    std::vector<float> fitted = std::move(values_.values);
    values_ = builder_.hierarchy();
    std::copy(fitted.begin(), fitted.end(), values_.values.begin());
  }

  void collectCells()
  {
    std::vector<std::int32_t> rowOf(values_.cells.size(), -1);
    for (std::size_t c = 0; c < cells_.size(); ++c)
    {
      rowOf[static_cast<std::size_t>(cells_[c].value)] = static_cast<std::int32_t>(c);
    }
    std::vector<CellId> cells = leafCells(values_, front_.level(values_));
    std::vector<CellRows> rows(cells.size());
    tbb::parallel_for(std::size_t{ 0 }, cells.size(), [&](std::size_t c) {
      progress_.check();
      const std::int32_t old = rowOf[static_cast<std::size_t>(cells[c].value)];
      rows[c] = old >= 0 ? std::move(rows_[static_cast<std::size_t>(old)]) : builder_.rows(cells[c]);
    });
    cells_.swap(cells);
    rows_.swap(rows);
  }

  void measure()
  {
    const std::size_t fields = values_.fields.size();
    tbb::parallel_for(std::size_t{ 0 }, cells_.size(), [&](std::size_t i) {
      progress_.check();
      const CellErrors errors = builder_.errors(values_, cells_[i]);
      const auto c = static_cast<std::size_t>(cells_[i].value);
      values_.interfaceErrors[c] = errors.interfaceError;
      std::copy(errors.fieldErrors.begin(), errors.fieldErrors.end(),
        values_.fieldErrors.begin() + static_cast<std::ptrdiff_t>(c * fields));
    });
  }

  HierarchyBuilder& builder_;
  const ErrorBounds& bounds_;
  const FitOptions& options_;
  Progress& progress_;
  Criterion criterion_;
  Front front_;
  Hierarchy values_;
  std::vector<CellId> cells_;
  std::vector<CellRows> rows_; ///< one per cell
};
}

FittedLevel fitLevel(
  HierarchyBuilder& builder, const ErrorBounds& bounds, const FitOptions& options, Progress& progress)
{
  return Fitting(builder, bounds, options, progress).run();
}
}
