#include "Extract/CorrectVolumes.h"

#include "Extract/CellCutter.h"
#include "Extract/CellsAround.h"

#include <Eigen/Dense>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace strata
{
namespace
{
constexpr int maximumSweeps = 30;
/// Errors of a cell, as a part of its volume, below which sweeping ends.
constexpr double cellTolerance = 4e-4;
constexpr double totalTolerance = 1e-7;
/// Regions that are missing are let go below this part of a cell.
constexpr double smallestRaised = 2e-4;
/// Largest change of a value in one sweep.
constexpr double largestStep = 0.2;

template<typename Visit>
void forEach(std::int32_t count, Progress& progress, const Visit& visit)
{
  tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, count, 256), [&](const auto& range) {
    progress.check();
    for (std::int32_t i = range.begin(); i < range.end(); ++i)
    {
      visit(i);
    }
  });
}

class VolumeCorrection
{
public:
  VolumeCorrection(const CellComplex& complex, const GridTopology& topology, const Fractions& fractions,
    double minimumFraction, MaterialValues& values, Progress& progress) :
    complex_(complex), fractions_(fractions), minimumFraction_(minimumFraction), values_(values), progress_(progress),
    winners_(static_cast<std::size_t>(complex.vertexCount())), reach_(winners_.size(), 0), cells_(complex.cells.size()), around_(complex)
  {
    findFixed(topology);
  }

  void run()
  {
    for (int sweep = 0; sweep < maximumSweeps; ++sweep)
    {
      progress_.update(static_cast<double>(sweep) / maximumSweeps);
      measure();
      const double worst = largestError();
      if (getenv("XLOG")) printf("sweep %d worst %g total %g\n", sweep, worst, totalError());
      if (worst < cellTolerance)
      {
        break;
      }
      applySteps();
    }
    for (int sweep = 0; sweep < 3; ++sweep)
    {
      measure();
      if (getenv("XLOG")) printf("global %d worst %g total %g\n", sweep, largestError(), totalError());
      shiftAll();
    }
  }

private:
  struct CellState
  {
    std::vector<Share> targets; ///< volumes that the cell is to have
    std::vector<Share> steps;   ///< changes of the values that the cell asks for
    std::uint64_t regions = 0;  ///< materials that have a region in the cell
    double error = 0.0;         ///< largest error over the cell's volume
    CellCutter::Regions measured;
    double weight = 1.0; 
  };

  void findFixed(const GridTopology& topology)
  {
    fixed_.assign(winners_.size(), 0);
    forEach(complex_.nodeCount(), progress_, [&](std::int32_t v) {
      std::vector<Index> cells;
      topology.cellsAround(complex_.nodes[v], cells);
      fixed_[v] = static_cast<Index>(cells.size()) != around_.start[v + 1] - around_.start[v] ? 1 : 0;
    });
    forEach(complex_.faceCount(), progress_, [&](std::int32_t f) {
      const std::int32_t v = complex_.faceVertex(f);
      const int cells = complex_.faceCells[f][1] < 0 ? 1 : 2;
      fixed_[v] = around_.start[v + 1] - around_.start[v] != cells ? 1 : 0;
    });
  }

  void measure()
  {
    forEach(complex_.vertexCount(), progress_, [this](std::int32_t v) { winners_[v] = values_.winner(v); });
    tbb::enumerable_thread_specific<CellCutter> cutters([this] { return CellCutter(complex_, values_, winners_); });
    forEach(complex_.cellCount(), progress_, [&](std::int32_t c) {
      CellState& state = cells_[c];
      const bool first = state.measured.total == 0.0;
      const std::uint8_t only = cutters.local().only(c);
      if (only == CellCutter::several || first)
      {
        cutters.local().volumes(c, state.measured);
      }
      else
      {
        const double total = state.measured.total;
        state.measured.clear();
        state.measured.total = total;
        state.measured.volumes[state.measured.of(only)] = total;
      }
      state.regions = 0;
      for (std::size_t i = 0; i < state.measured.materials.size(); ++i)
      {
        state.regions |= state.measured.volumes[i] > 0.0 ? std::uint64_t{ 1 } << state.measured.materials[i] : 0;
      }
    });
    forEach(complex_.vertexCount(), progress_, [this](std::int32_t v) {
      reach_[v] = 0;
      for (std::int32_t i = around_.start[v]; i < around_.start[v + 1]; ++i)
      {
        reach_[v] |= cells_[around_.cells[i]].regions;
      }
    });
    forEach(complex_.cellCount(), progress_, [this](std::int32_t c) {
      findTargets(c);
      findSteps(c);
    });
  }

  /// The volumes that a cell's materials are to have: those that can't be reached go to the largest.
  void findTargets(std::int32_t c)
  {
    CellState& state = cells_[c];
    std::uint64_t reached = 0;
    around_.forEachVertex(complex_, c, [&](std::int32_t v) { reached |= reach_[v]; });
    std::vector<Share>& shares = state.targets;
    fractions_.ofCell(complex_.cells[c], shares);
    const std::size_t winner = largest(shares);
    double sum = 0.0;
    for (std::size_t i = 0; i < shares.size(); ++i)
    {
      const bool kept =
        i == winner || shares[i].value >= minimumFraction_ || ((reached >> shares[i].material) & 1) != 0;
      shares[i].value = kept ? shares[i].value : 0.0;
      sum += shares[i].value;
    }
    for (Share& share : shares)
    {
      share.value *= state.measured.total / sum;
    }
  }

  static double valueOf(const std::vector<Share>& shares, std::uint8_t material)
  {
    for (const Share& share : shares)
    {
      if (share.material == material)
      {
        return share.value;
      }
    }
    return 0.0;
  }

  void findSteps(std::int32_t c)
  {
    CellState& state = cells_[c];
    const CellCutter::Regions& regions = state.measured;
    state.steps.clear();
    state.error = 0.0;
    const auto count = static_cast<Eigen::Index>(regions.materials.size());
    Eigen::VectorXd missing(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      missing[i] = valueOf(state.targets, regions.materials[i]) - regions.volumes[i];
      state.error = std::max(state.error, std::abs(missing[i]) / regions.total);
    }
    const std::uint64_t present = state.regions;
    for (const Share& target : state.targets)
    {
      if (target.value > smallestRaised * regions.total && ((present >> target.material) & 1) == 0)
      {
        state.error = std::max(state.error, target.value / regions.total);
        state.steps.push_back({ target.material, raise(c, target.material, target.value / regions.total) });
      }
    }
    if (count < 2)
    {
      return;
    }
    Eigen::MatrixXd slopes(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      for (Eigen::Index j = 0; j < count; ++j)
      {
        slopes(i, j) = regions.derivatives[i * MaterialSet::capacity + regions.materials[j]];
      }
    }
    slopes.diagonal().array() += 1e-3 * slopes.trace() / count + 1e-9 * std::cbrt(regions.total * regions.total);
    const Eigen::VectorXd step = slopes.ldlt().solve(missing);
    const double size = std::cbrt(regions.total);
    double damping = getenv("XOM") ? atof(getenv("XOM")) : 1.2;
    const double relaxed = damping;
    for (Eigen::Index i = 0; i < count; ++i)
    {
      // A corner that is cut off grows as the cube of the step: Newton would overshoot.
      const double growth = 1.0 + missing[i] / regions.volumes[i];
      if (growth > 1.001)
      {
        damping = std::min(damping, relaxed * 3.0 * (std::cbrt(growth) - 1.0) / (growth - 1.0));
      }
    }
    for (Eigen::Index i = 0; i < count; ++i)
    {
      state.steps.push_back({ regions.materials[i], std::clamp(damping * step[i], -largestStep * size, largestStep * size) });
    }
  }

  /// How far a material without a region must rise to win at a vertex of the cell, and a little more.
  double raise(std::int32_t c, std::uint8_t material, double fraction) const
  {
    double gap = std::numeric_limits<double>::infinity();
    around_.forEachVertex(complex_, c, [&](std::int32_t v) {
      gap = std::min(gap, values_.at(v, winners_[v]) - values_.at(v, material));
    });
    const double size = std::cbrt(cells_[c].measured.total);
    return std::min(gap + (0.1 * std::min(1.0, 10.0 * fraction) + 1e-3) * size, largestStep * size);
  }

  void applySteps()
  {
    forEach(complex_.vertexCount(), progress_, [this](std::int32_t v) {
      for (Index i = values_.start[v]; i < values_.start[v + 1] && !fixed_[v]; ++i)
      {
        double sum = 0.0;
        double count = 0.0;
        for (std::int32_t k = around_.start[v]; k < around_.start[v + 1]; ++k)
        {
          for (const Share& step : cells_[around_.cells[k]].steps)
          {
            if (step.material == values_.materials[i])
            {
              static const double wf = getenv("XE") ? atof(getenv("XE")) : 3e-4;
              const double weight = cells_[around_.cells[k]].error + wf;
              sum += weight * step.value;
              count += weight;
            }
          }
        }
        values_.values[i] += count > 0.0 ? sum / count : 0.0;
      }
    });
  }

  double largestError() const
  {
    double result = 0.0;
    for (const CellState& state : cells_)
    {
      result = std::max(result, state.error);
    }
    return result;
  }
  double totalError() const
  {
    double result = 0.0;
    double all = 0;
    for (const CellState& state : cells_)
    {
      result += valueOf(state.targets, 0);
      all += valueOf(state.targets, 0);
      for (size_t i = 0; i < state.measured.materials.size(); ++i)
        if (state.measured.materials[i] == 0) result -= state.measured.volumes[i];
    }
    return result/all;
  }

  /// Raises each material everywhere by what its total volume still lacks.
  void shiftAll()
  {
    const int count = fractions_.materialCount();
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd missing = Eigen::VectorXd::Zero(count);
    for (const CellState& state : cells_)
    {
      for (const Share& target : state.targets)
      {
        missing[target.material] += target.value;
      }
      const CellCutter::Regions& regions = state.measured;
      for (std::size_t i = 0; i < regions.materials.size(); ++i)
      {
        missing[regions.materials[i]] -= regions.volumes[i];
        for (int j = 0; j < count; ++j)
        {
          slopes(regions.materials[i], j) += regions.derivatives[i * MaterialSet::capacity + static_cast<std::size_t>(j)];
        }
      }
    }
    const double scale = slopes.trace() / count;
    if (scale <= 0.0)
    {
      return;
    }
    slopes.diagonal().array() += 1e-9 * scale;
    const Eigen::VectorXd step = slopes.ldlt().solve(missing);
    forEach(complex_.vertexCount(), progress_, [&](std::int32_t v) {
      for (Index i = values_.start[v]; i < values_.start[v + 1] && !fixed_[v]; ++i)
      {
        values_.values[i] += step[values_.materials[i]];
      }
    });
  }

  const CellComplex& complex_;
  const Fractions& fractions_;
  double minimumFraction_;
  MaterialValues& values_;
  Progress& progress_;
  std::vector<std::uint8_t> winners_;
  std::vector<std::uint64_t> reach_; ///< by vertex: materials that have a region in a cell around
  std::vector<std::uint8_t> fixed_;
  std::vector<CellState> cells_;
  CellsAround around_;
};
}

void correctVolumes(const CellComplex& complex, const GridTopology& topology, const Fractions& fractions,
  double minimumFraction, MaterialValues& values, Progress& progress)
{
  VolumeCorrection(complex, topology, fractions, minimumFraction, values, progress).run();
}
}
