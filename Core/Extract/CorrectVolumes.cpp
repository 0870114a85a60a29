#include "Extract/CorrectVolumes.h"

#include "Extract/BalanceTotals.h"
#include "Extract/CellVolumes.h"
#include "Extract/ForEach.h"
#include "Extract/SettleCells.h"
#include "Extract/SmearedFractions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata
{
namespace
{
/// What is left then, the centres of the cells settle.
constexpr int maximumSweeps = 25;
/// Errors as parts of a cell's volume: a cell below the first asks for nothing; sweeps end when all are below the
/// second; a region that is missing is not called back below the third.
constexpr double quietError = 1e-4;
constexpr double cellTolerance = 4e-4;
constexpr double smallestRegion = 2e-4;
/// Largest change of a value in one sweep and in all, as parts of the cell's size.
constexpr double largestStep = 0.2;
constexpr double largestShift = 4.0;
/// Steps are a little longer than Newton's, for the neighbours share only some of the vertices.
constexpr double relaxation = 1.2;
/// Totals are balanced until no material lacks more than this part of all volume, or so many times.
constexpr double totalTolerance = 1e-10;
constexpr int maximumBalances = 12;
/// Largest change of a value, as a part of the cell's size, that makes up for fractions too small for a region.
constexpr double largestMakeUp = 2e-4;
/// The same where fractions are smeared: there no single cell is to be right.
constexpr double largestSmearedMakeUp = 0.25;
/// Added to a cell's error to weigh its step among those of its neighbours.
constexpr double leastWeight = 3e-4;

class VolumeCorrection
{
public:
  VolumeCorrection(const MixedRegion& region, double minimumFraction, MaterialValues& values, Progress& progress) :
    region_(region), complex_(region.complex), around_(region.around), values_(values), start_(values.values),
    progress_(progress), volumes_(region, values, minimumFraction, progress), requests_(complex_.cells.size()),
    changed_(static_cast<std::size_t>(complex_.vertexCount()), 1), materialCount_(region.fractions.materialCount())
  {}

  /// Returns to what degree smeared fractions were gathered.
  double run(bool gather)
  {
    update();
    const double degree = gather ? gatherSmeared() : 0.0;
    for (int sweep = 0; sweep < maximumSweeps && largestError() >= cellTolerance; ++sweep)
    {
      progress_.update(static_cast<double>(sweep) / maximumSweeps);
      applySteps();
      update();
    }
    balanceTotals(Eigen::VectorXd::Zero(materialCount_));
    settleCells(complex_, volumes_, volumes_.winners(), values_, changed_, progress_);
    update();
    const double limit = largestMakeUp + degree * (largestSmearedMakeUp - largestMakeUp);
    balanceTotals(affordable(droppedVolumes(volumes_, region_, progress_), limit));
    return degree;
  }

private:
  /// Where fractions are smeared, lets cells ask for volumes that move the interface as a whole. Returns the degree.
  double gatherSmeared()
  {
    const SmearedFractions smeared(region_, volumes_, progress_);
    if (smeared.degree() > 0.0)
    {
      smeared.clearOffInterface(values_, progress_);
      start_ = values_.values;
      std::fill(changed_.begin(), changed_.end(), std::uint8_t{ 1 });
      update();
      std::vector<std::vector<Share>> targets = smeared.targets(progress_);
      for (std::int32_t c = 0; c < complex_.cellCount(); ++c)
      {
        volumes_.replaceTargets(c, std::move(targets[c]));
      }
      forEach(complex_.cellCount(), progress_, [this](std::int32_t c) { findRequest(c); });
    }
    return smeared.degree();
  }

  /// What a cell asks for.
  struct Request
  {
    std::vector<Share> steps; ///< changes of the materials' values at its vertices
    double error = 0.0;       ///< largest error of a material over the cell's volume
  };

  void update()
  {
    volumes_.update(changed_);
    std::fill(changed_.begin(), changed_.end(), std::uint8_t{ 0 });
    forEach(complex_.cellCount(), progress_, [this](std::int32_t c) { findRequest(c); });
  }

  void findRequest(std::int32_t c)
  {
    const CellVolume& cell = volumes_[c];
    Request& request = requests_[c];
    request.steps.clear();
    request.error = 0.0;
    for (const Share& volume : cell.volumes)
    {
      const double error = std::abs(volume.value - valueOf(cell.targets, volume.material)) / cell.total;
      request.error = std::max(request.error, error);
    }
    for (const Share& target : cell.targets)
    {
      if (target.value > smallestRegion * cell.total && valueOf(cell.volumes, target.material) <= 0.0)
      {
        request.error = std::max(request.error, target.value / cell.total);
        request.steps.push_back({ target.material, raise(c, target) });
      }
    }
    if (request.error >= quietError && cell.volumes.size() > 1)
    {
      addNewtonSteps(cell, request);
    }
  }

  /// How far a material without a region must rise to win at a vertex of the cell, and a little more.
  double raise(std::int32_t c, const Share& target) const
  {
    double gap = std::numeric_limits<double>::infinity();
    around_.forEachVertex(complex_, c,
      [&](std::int32_t v) { gap = std::min(gap, values_.at(v, volumes_.winner(v)) - values_.at(v, target.material)); });
    const double size = std::cbrt(volumes_[c].total);
    return std::min(gap + (std::min(0.02, target.value / volumes_[c].total) + 1e-3) * size, largestStep * size);
  }

  static void addNewtonSteps(const CellVolume& cell, Request& request)
  {
    const auto count = static_cast<Eigen::Index>(cell.volumes.size());
    Eigen::VectorXd missing(count);
    double damping = relaxation;
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const Share& volume = cell.volumes[static_cast<std::size_t>(i)];
      missing[i] = valueOf(cell.targets, volume.material) - volume.value;
      // A corner that is cut off grows as the cube of the step: there Newton's would be too long.
      const double growth = volume.value > 0.0 ? 1.0 + missing[i] / volume.value : 1.0;
      if (growth > 1.001)
      {
        damping = std::min(damping, relaxation * 3.0 * (std::cbrt(growth) - 1.0) / (growth - 1.0));
      }
    }
    const double size = std::cbrt(cell.total);
    Eigen::MatrixXd slopes = cell.slopes;
    slopes.diagonal().array() += 1e-3 * slopes.trace() / static_cast<double>(count) + 1e-9 * size * size;
    const Eigen::VectorXd step = damping * slopes.ldlt().solve(missing);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      request.steps.push_back({ cell.volumes[static_cast<std::size_t>(i)].material,
        std::clamp(step[i], -largestStep * size, largestStep * size) });
    }
  }

  void applySteps()
  {
    forEach(complex_.vertexCount(), progress_, [this](std::int32_t v) {
      bool asked = false;
      double smallest = std::numeric_limits<double>::infinity();
      for (std::int32_t i = around_.start[v]; i < around_.start[v + 1]; ++i)
      {
        asked = asked || !requests_[around_.cells[i]].steps.empty();
        smallest = std::min(smallest, volumes_[around_.cells[i]].total);
      }
      if (!asked || region_.outer[v])
      {
        return;
      }
      changed_[v] = 1;
      const double limit = largestShift * std::cbrt(smallest);
      for (Index entry = values_.start[v]; entry < values_.start[v + 1]; ++entry)
      {
        values_.values[entry] = std::clamp(
          values_.values[entry] + meanStep(v, values_.materials[entry]), start_[entry] - limit, start_[entry] + limit);
      }
    });
  }

  /// The mean of the steps that the cells around ask for, weighted by their errors.
  double meanStep(std::int32_t v, std::uint8_t material) const
  {
    double sum = 0.0;
    double weights = 0.0;
    for (std::int32_t i = around_.start[v]; i < around_.start[v + 1]; ++i)
    {
      const Request& request = requests_[around_.cells[i]];
      const double weight = request.error + leastWeight;
      for (const Share& step : request.steps)
      {
        if (step.material == material)
        {
          sum += weight * step.value;
          weights += weight;
        }
      }
    }
    return weights > 0.0 ? sum / weights : 0.0;
  }

  double largestError() const
  {
    double largest = 0.0;
    for (const Request& request : requests_)
    {
      largest = std::max(largest, request.error);
    }
    return largest;
  }

  /// As much of what was dropped as changes of the values up to `most` of a cell's size can make up for.
  Eigen::VectorXd affordable(const Eigen::VectorXd& dropped, double most) const
  {
    const Eigen::VectorXd steps = rises(volumes_, complex_.cellCount(), dropped);
    const double limit = most * smallestSize();
    const double largest = steps.size() > 0 ? steps.maxCoeff() - steps.minCoeff() : 0.0;
    return largest > limit ? (limit / largest * dropped).eval() : dropped;
  }

  /// Cube root of the smallest cell's volume.
  double smallestSize() const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::int32_t c = 0; c < complex_.cellCount(); ++c)
    {
      smallest = std::min(smallest, volumes_[c].total);
    }
    return std::cbrt(smallest);
  }

  /// Raises each material everywhere by what its total volume still lacks, that in `extra` included. A material that
  /// has hardly any border to move would rise without limit: steps are bounded, and what makes things worse is undone.
  void balanceTotals(const Eigen::VectorXd& extra)
  {
    const double limit = largestStep * smallestSize();
    const auto missing = [&] {
      return (extra + missingVolumes(volumes_, complex_.cellCount(), materialCount_)).eval();
    };
    double total = 0.0;
    for (std::int32_t c = 0; c < complex_.cellCount(); ++c)
    {
      total += volumes_[c].total;
    }
    Eigen::VectorXd lacking = missing();
    for (int balance = 0; balance < maximumBalances && lacking.size() > 0; ++balance)
    {
      const double before = lacking.cwiseAbs().maxCoeff();
      if (before <= totalTolerance * total)
      {
        return;
      }
      const Eigen::VectorXd wanted = rises(volumes_, complex_.cellCount(), lacking);
      if (!wanted.allFinite())
      {
        return;
      }
      const Eigen::VectorXd steps = wanted.cwiseMax(-limit).cwiseMin(limit);
      raiseAll(steps);
      lacking = missing();
      if (lacking.cwiseAbs().maxCoeff() > before)
      {
        raiseAll(-steps);
        return;
      }
    }
  }

  void raiseAll(const Eigen::VectorXd& steps)
  {
    forEach(complex_.vertexCount(), progress_, [&](std::int32_t v) {
      for (Index i = values_.start[v]; i < values_.start[v + 1] && !region_.outer[v]; ++i)
      {
        values_.values[i] += steps[values_.materials[i]];
      }
    });
    std::fill(changed_.begin(), changed_.end(), std::uint8_t{ 1 });
    update();
  }

  const MixedRegion& region_;
  const CellComplex& complex_;
  const CellsAround& around_;
  MaterialValues& values_;
  std::vector<double> start_; ///< the values before the correction
  Progress& progress_;
  CellVolumes volumes_;
  std::vector<Request> requests_;
  std::vector<std::uint8_t> changed_; ///< by vertex
  int materialCount_;
};
}

double correctVolumes(
  const MixedRegion& region, const ExtractOptions& options, MaterialValues& values, Progress& progress)
{
  return VolumeCorrection(region, options.minimumVolumeFraction, values, progress).run(options.gatherSmearedFractions);
}
}
