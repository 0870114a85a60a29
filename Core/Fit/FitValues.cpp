#include "Fit/FitValues.h"

#include "Fit/RowErrors.h"
#include "Fit/Stars.h"
#include "Fit/VertexFit.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
/// One pass after the other over a level's vertices.
class LevelFit
{
public:
  LevelFit(Hierarchy& values, const std::vector<CellId>& cells, const std::vector<CellRows>& rows,
    const std::vector<std::uint8_t>& fixed, const ErrorBounds& bounds) :
    values_(values),
    cells_(cells), rows_(rows), fixed_(fixed), bounds_(bounds), errors_(cells.size(), 0.0), moved_(fixed.size())
  {
    std::transform(fixed.begin(), fixed.end(), moved_.begin(), [](std::uint8_t f) { return f == 0 ? 1 : 0; });
  }

  void sweep(Progress& progress)
  {
    updateErrors();
    const Stars stars(values_, cells_, worthFittingVertices());
    for (const std::vector<std::size_t>& color : stars.colors())
    {
      tbb::parallel_for(std::size_t{ 0 }, color.size(), [&](std::size_t i) {
        progress.check();
        fit(stars.vertex(color[i]), stars.cellsAt(color[i]));
      });
    }
  }

private:
  /// Errors of cells none of whose corners moved are as before; where all are fixed, nobody asks for them.
  void updateErrors()
  {
    const auto hasMoved = [&](VertexId v) { return moved_[static_cast<std::size_t>(v.value)] != 0; };
    tbb::parallel_for(std::size_t{ 0 }, cells_.size(), [&](std::size_t c) {
      const HierarchyCell& cell = values_.cell(cells_[c]);
      if (std::any_of(cell.corners.begin(), cell.corners.end(), hasMoved))
      {
        errors_[c] = relativeError(values_, cell, rows_[c], bounds_);
      }
    });
    std::fill(moved_.begin(), moved_.end(), std::uint8_t{ 0 });
  }

  std::vector<VertexId> worthFittingVertices() const
  {
    std::vector<std::uint8_t> left = fixed_;
    std::vector<VertexId> vertices;
    for (std::size_t c = 0; c < cells_.size(); ++c)
    {
      for (const VertexId corner : values_.cell(cells_[c]).corners)
      {
        std::uint8_t& isLeft = left[static_cast<std::size_t>(corner.value)];
        if (errors_[c] >= worthFitting && isLeft == 0)
        {
          isLeft = 1;
          vertices.push_back(corner);
        }
      }
    }
    return vertices;
  }

  void fit(VertexId vertex, const std::vector<std::size_t>& star)
  {
    const auto v = static_cast<std::size_t>(vertex.value);
    const float* first = values_.values.data() + values_.valueOffsets[v];
    const std::vector<float> before(first, first + values_.vertexMaterials[v].size() * values_.valuesPerMaterial);
    fitVertex(values_, cells_, rows_, bounds_, vertex, star);
    moved_[v] = std::equal(before.begin(), before.end(), first) ? 0 : 1;
  }

  Hierarchy& values_;
  const std::vector<CellId>& cells_;
  const std::vector<CellRows>& rows_;
  const std::vector<std::uint8_t>& fixed_;
  const ErrorBounds& bounds_;
  std::vector<double> errors_;      ///< [cell], relative to its bounds
  std::vector<std::uint8_t> moved_; ///< [vertex], 1 if its values changed in the last pass
};
}

void fitValues(Hierarchy& values, const std::vector<CellId>& cells, const std::vector<CellRows>& rows,
  const std::vector<std::uint8_t>& fixed, const ErrorBounds& bounds, int sweeps, Progress& progress)
{
  LevelFit fit(values, cells, rows, fixed, bounds);
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    fit.sweep(progress);
  }
}
}
