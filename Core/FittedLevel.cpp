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
  Fitting(HierarchyBuilder& builder, const InterfaceTrees* original, const ErrorBounds& bounds,
    const FitOptions& options, Progress& progress) :
    builder_(builder),
    bounds_(bounds), options_(options), progress_(progress), criterion_(bounds, {}, options.maximumLevel),
    front_(builder.hierarchy(), false)
  {
    if (original)
    {
      certificate_ = std::make_unique<InterfaceCertificate>(builder, *original, criterion_);
    }
  }

  FittedLevel run()
  {
    growTo(certificate_ ? options_.certifiedLooseness : options_.looseness);
    takeOverHierarchy();
    for (int round = 1;; ++round)
    {
      collectCells();
      fitValues(values_, cells_, rows_, settledVertices(), bounds_, options_.sweeps, progress_);
      measure();
      Level level = front_.level(builder_.hierarchy());
      const std::vector<CellId> tooCoarse = findTooCoarse(level);
      if (tooCoarse.empty())
      {
        return { std::move(values_), std::move(level), std::move(certificate_) };
      }
      fixFailing(tooCoarse);
      split(tooCoarse);
      countFailures(tooCoarse);
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

  std::vector<CellId> findTooCoarse(Level& level)
  {
    std::vector<CellId> result;
    std::copy_if(cells_.begin(), cells_.end(), std::back_inserter(result),
      [&](CellId c) { return criterion_.mustSplit(values_, c, 1.0); });
    if (certificate_)
    {
      certificate_->measure(values_, level, progress_);
      const std::vector<CellId> more = certificate_->tooCoarse(values_);
      result.insert(result.end(), more.begin(), more.end());
    }
    return result;
  }

  /// Where splitting has not helped, the fitted values are to blame: they follow the points that the fit looks at, and
  /// errors are taken over more than those. With the hierarchy's own values, refinement ends as it does without fits.
  void fixFailing(const std::vector<CellId>& tooCoarse)
  {
    failures_.resize(values_.cells.size(), 0);
    for (const CellId c : tooCoarse)
    {
      if (failures_[static_cast<std::size_t>(c.value)] >= options_.mostFailures)
      {
        for (const VertexId v : values_.cell(c).corners)
        {
          restore(v);
        }
      }
    }
  }

  void restore(VertexId vertex)
  {
    const auto v = static_cast<std::size_t>(vertex.value);
    const auto first = static_cast<std::ptrdiff_t>(values_.valueOffsets[v]);
    const std::ptrdiff_t count = values_.vertexMaterials[v].size() * values_.valuesPerMaterial;
    const std::vector<float>& own = builder_.hierarchy().values;
    std::copy(own.begin() + first, own.begin() + first + count, values_.values.begin() + first);
    fixed_[v] = 1;
  }

  /// Children know how often their ancestors fell short in a row.
  void countFailures(const std::vector<CellId>& split)
  {
    failures_.resize(builder_.hierarchy().cells.size(), 0);
    for (const CellId c : split)
    {
      const auto child = static_cast<std::size_t>(builder_.hierarchy().cell(c).firstChild.value);
      failures_[child] = failures_[child + 1] =
        static_cast<std::uint8_t>(std::min(failures_[static_cast<std::size_t>(c.value)] + 1, 255));
    }
  }

  /// New cells and vertices come from the hierarchy; fitted values and the errors measured with them stay.
  void takeOverHierarchy()
  {
    const Hierarchy fitted = std::move(values_);
    values_ = builder_.hierarchy();
    std::copy(fitted.values.begin(), fitted.values.end(), values_.values.begin());
    std::copy(fitted.interfaceErrors.begin(), fitted.interfaceErrors.end(), values_.interfaceErrors.begin());
    std::copy(fitted.fieldErrors.begin(), fitted.fieldErrors.end(), values_.fieldErrors.begin());
    fixed_.resize(values_.vertices.size(), 0);
    measured_.resize(values_.cells.size(), 0);
  }

  /// Vertices none of whose cells are new have been fitted to them before.
  std::vector<std::uint8_t> settledVertices() const
  {
    std::vector<std::uint8_t> settled(fixed_.size(), 1);
    for (const CellId c : cells_)
    {
      if (measured_[static_cast<std::size_t>(c.value)] == 0)
      {
        for (const VertexId v : values_.cell(c).corners)
        {
          settled[static_cast<std::size_t>(v.value)] = fixed_[static_cast<std::size_t>(v.value)];
        }
      }
    }
    return settled;
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

  /// Whether a cell has the values at its corners that it was last measured with.
  bool isMeasured(CellId cell) const
  {
    const auto isSame = [&](VertexId vertex) {
      const auto v = static_cast<std::size_t>(vertex.value);
      const auto first = static_cast<std::ptrdiff_t>(values_.valueOffsets[v]);
      const std::ptrdiff_t count = values_.vertexMaterials[v].size() * values_.valuesPerMaterial;
      const auto own = values_.values.begin() + first;
      return std::equal(own, own + count, measuredValues_.begin() + first);
    };
    const std::array<VertexId, 4>& corners = values_.cell(cell).corners;
    return measured_[static_cast<std::size_t>(cell.value)] != 0 && std::all_of(corners.begin(), corners.end(), isSame);
  }

  void measure()
  {
    const std::size_t fields = values_.fields.size();
    tbb::parallel_for(std::size_t{ 0 }, cells_.size(), [&](std::size_t i) {
      progress_.check();
      if (isMeasured(cells_[i]))
      {
        return;
      }
      const CellErrors errors = builder_.errors(values_, cells_[i]);
      const auto c = static_cast<std::size_t>(cells_[i].value);
      measured_[c] = 1;
      values_.interfaceErrors[c] = errors.interfaceError;
      std::copy(errors.fieldErrors.begin(), errors.fieldErrors.end(),
        values_.fieldErrors.begin() + static_cast<std::ptrdiff_t>(c * fields));
    });
    measuredValues_ = values_.values;
  }

  HierarchyBuilder& builder_;
  const ErrorBounds& bounds_;
  const FitOptions& options_;
  Progress& progress_;
  Criterion criterion_;
  Front front_;
  std::unique_ptr<InterfaceCertificate> certificate_;
  Hierarchy values_;
  std::vector<CellId> cells_;
  std::vector<CellRows> rows_;         ///< one per cell
  std::vector<std::uint8_t> measured_; ///< [cell], 1 if its errors were measured
  std::vector<float> measuredValues_;  ///< the values that they were measured with
  std::vector<std::uint8_t> fixed_;    ///< [vertex], 1 if it has the hierarchy's values for good
  std::vector<std::uint8_t> failures_; ///< [cell], of its parent, grandparent and so on, until one held its bounds
};
}

FittedLevel fitLevel(HierarchyBuilder& builder, const InterfaceTrees* original, const ErrorBounds& bounds,
  const FitOptions& options, Progress& progress)
{
  return Fitting(builder, original, bounds, options, progress).run();
}
}
