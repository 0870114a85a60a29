#include "Extract/SettleCells.h"

#include "Extract/ForEach.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// Errors as parts of a cell's volume: a cell below the first is left alone, the second ends the search.
constexpr double quietError = 1e-4;
constexpr double tolerance = 2e-5;
/// Largest change of a value, and largest step of Newton's method, as parts of the cell's size.
constexpr double largestShift = 1.0;
constexpr double largestStep = 0.25;
constexpr int maximumSteps = 16;

/// Settles one cell after another. A workspace: one per thread.
class CellSettler
{
public:
  CellSettler(const CellComplex& complex, const std::vector<std::uint8_t>& winners, MaterialValues& values) :
    complex_(complex), values_(values), cutter_(complex, values, winners)
  {}

  /// Returns whether the values at the cell's centre were moved.
  bool settle(std::int32_t c, const CellVolume& cell)
  {
    cell_ = c;
    total_ = cell.total;
    targets_ = &cell.targets;
    begin_ = values_.start[complex_.cellVertex(c)];
    end_ = values_.start[complex_.cellVertex(c) + 1];
    const bool right = cell.volumes.size() == 1 && cell.targets.size() == 1;
    if (right || cell.targets.empty() || measure() < quietError)
    {
      return false;
    }
    start_.assign(values_.values.begin() + begin_, values_.values.begin() + end_);
    const double before = error_;
    best_ = start_;
    leastError_ = error_;
    if (regions_.materials.size() > 2)
    {
      newton();
    }
    restoreBest();
    if (leastError_ > quietError)
    {
      searchWorst();
      restoreBest();
    }
    return leastError_ < before;
  }

private:
  double size() const { return std::cbrt(total_); }

  /// Measures the regions; returns the largest error.
  double measure()
  {
    cutter_.volumes(cell_, regions_);
    findError();
    return error_;
  }

  double regionOf(std::uint8_t material) const
  {
    const auto found = std::find(regions_.materials.begin(), regions_.materials.end(), material);
    return found == regions_.materials.end() ? 0.0 : regions_.volumes[found - regions_.materials.begin()];
  }

  void findError()
  {
    error_ = 0.0;
    for (std::size_t i = 0; i < regions_.materials.size(); ++i)
    {
      const double target = valueOf(*targets_, regions_.materials[i]);
      error_ = std::max(error_, std::abs(regions_.volumes[i] - target) / total_);
    }
    for (const Share& target : *targets_)
    {
      error_ = std::max(error_, std::abs(regionOf(target.material) - target.value) / total_);
    }
  }

  void keepBest()
  {
    if (error_ < leastError_)
    {
      leastError_ = error_;
      best_.assign(values_.values.begin() + begin_, values_.values.begin() + end_);
    }
  }

  void restoreBest() { std::copy(best_.begin(), best_.end(), values_.values.begin() + begin_); }

  void shift(Index entry, double step)
  {
    const double limit = largestShift * size();
    const double start = start_[static_cast<std::size_t>(entry - begin_)];
    values_.values[entry] = std::clamp(values_.values[entry] + step, start - limit, start + limit);
  }

  /// All materials at once.
  void newton()
  {
    for (int step = 0; step < maximumSteps && leastError_ > tolerance; ++step)
    {
      cutter_.volumes(cell_, regions_, CellCutter::Rise::Centre);
      findError();
      keepBest();
      const auto count = static_cast<Eigen::Index>(regions_.materials.size());
      Eigen::MatrixXd slopes = Eigen::Map<const Eigen::MatrixXd>(regions_.derivatives.data(), count, count);
      slopes.diagonal().array() += 1e-4 * slopes.trace() / static_cast<double>(count) + 1e-9 * size() * size();
      Eigen::VectorXd missing(count);
      for (Eigen::Index i = 0; i < count; ++i)
      {
        missing[i] = valueOf(*targets_, regions_.materials[static_cast<std::size_t>(i)]) -
                     regions_.volumes[static_cast<std::size_t>(i)];
      }
      const Eigen::VectorXd steps = slopes.ldlt().solve(missing);
      const double limit = largestStep * size();
      for (Eigen::Index i = 0; i < count; ++i)
      {
        const Index entry = values_.find(complex_.cellVertex(cell_), regions_.materials[static_cast<std::size_t>(i)]);
        if (entry >= 0)
        {
          shift(entry, std::clamp(steps[i], -limit, limit));
        }
      }
    }
  }

  /// The entry whose volume is wrong by most.
  Index worstEntry() const
  {
    Index worst = begin_;
    double most = -1.0;
    for (Index entry = begin_; entry < end_; ++entry)
    {
      const std::uint8_t material = values_.materials[entry];
      const double error = std::abs(regionOf(material) - valueOf(*targets_, material));
      worst = error > most ? entry : worst;
      most = std::max(most, error);
    }
    return worst;
  }

  /// How much too large a material's region is, as a part of the cell, when it has a value at the centre.
  double excess(Index entry, double value)
  {
    values_.values[entry] = value;
    measure();
    keepBest();
    return (regionOf(values_.materials[entry]) - valueOf(*targets_, values_.materials[entry])) / total_;
  }

  /// Moves the worst material alone: its volume grows with its value, so the place is bracketed and found.
  void searchWorst()
  {
    measure();
    const Index entry = worstEntry();
    const double from = values_.values[entry];
    const auto at = [&](double x) { return excess(entry, from + x); };
    double a = 0.0;
    double fa = at(a);
    const double direction = fa > 0.0 ? -1.0 : 1.0;
    double width = std::min(4.0 * std::abs(fa) + 0.01, largestShift) * size();
    double b = direction * width;
    double fb = at(b);
    while (fa * fb > 0.0 && width < largestShift * size())
    {
      width = std::min(2.0 * width, largestShift * size());
      a = b;
      fa = fb;
      b = direction * width;
      fb = at(b);
    }
    for (int step = 0; step < maximumSteps && fa * fb < 0.0 && leastError_ > tolerance; ++step)
    {
      const double x = step % 3 == 2 ? 0.5 * (a + b) : (a * fb - b * fa) / (fb - fa);
      const double fx = at(x);
      (fx * fa > 0.0 ? a : b) = x;
      (fx * fa > 0.0 ? fa : fb) = fx;
    }
  }

  const CellComplex& complex_;
  MaterialValues& values_;
  CellCutter cutter_;
  CellCutter::Regions regions_;
  std::int32_t cell_ = 0;
  double total_ = 0.0;
  const std::vector<Share>* targets_ = nullptr;
  Index begin_ = 0, end_ = 0; ///< entries of the cell's centre
  double error_ = 0.0, leastError_ = 0.0;
  std::vector<double> start_, best_;
};
}

void settleCells(const CellComplex& complex, const CellVolumes& volumes, const std::vector<std::uint8_t>& winners,
  MaterialValues& values, std::vector<std::uint8_t>& changed, Progress& progress)
{
  tbb::enumerable_thread_specific<CellSettler> settlers([&] { return CellSettler(complex, winners, values); });
  forEach(complex.cellCount(), progress,
    [&](std::int32_t c) { changed[complex.cellVertex(c)] |= settlers.local().settle(c, volumes[c]) ? 1 : 0; });
}
}
