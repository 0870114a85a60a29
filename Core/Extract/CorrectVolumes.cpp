#include "Extract/CorrectVolumes.h"

#include "Extract/CellVolumes.h"
#include "Extract/ForEach.h"
#include "Extract/SettleCells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata
{
namespace
{
/// What is left then, the centres of the cells settle.
constexpr int maximumSweeps = 20;
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
/// Added to a cell's error to weigh its step among those of its neighbours.
constexpr double leastWeight = 3e-4;

class VolumeCorrection
{
public:
  VolumeCorrection(const CellComplex& complex, const GridTopology& topology, const Fractions& fractions,
    double minimumFraction, MaterialValues& values, Progress& progress) :
    complex_(complex),
    values_(values), start_(values.values), progress_(progress), around_(complex),
    volumes_(complex, around_, values, fractions, minimumFraction, progress), requests_(complex.cells.size()),
    changed_(static_cast<std::size_t>(complex.vertexCount()), 1), materialCount_(fractions.materialCount())
  {
    findFixed(topology);
  }

  void run()
  {
    update();
    for (int sweep = 0; sweep < maximumSweeps && largestError() >= cellTolerance; ++sweep)
    {
      progress_.update(static_cast<double>(sweep) / maximumSweeps);
      applySteps();
      update();
    }
    balanceTotals();
    settleCells(complex_, volumes_, volumes_.winners(), values_, changed_, progress_);
    update();
    balanceTotals();
  }

private:
  /// What a cell asks for.
  struct Request
  {
    std::vector<Share> steps; ///< changes of the materials' values at its vertices
    double error = 0.0;       ///< largest error of a material over the cell's volume
  };
  /// Vertices that cells outside the complex share stay: those cells are not looked at.
  void findFixed(const GridTopology& topology)
  {
    fixed_.assign(changed_.size(), 0);
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
      if (!asked || fixed_[v])
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

  /// Raises each material everywhere by what its total volume still lacks.
  void balanceTotals()
  {
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(materialCount_, materialCount_);
    Eigen::VectorXd missing = Eigen::VectorXd::Zero(materialCount_);
    for (std::int32_t c = 0; c < complex_.cellCount(); ++c)
    {
      const CellVolume& cell = volumes_[c];
      for (const Share& target : cell.targets)
      {
        missing[target.material] += target.value;
      }
      for (std::size_t i = 0; i < cell.volumes.size(); ++i)
      {
        missing[cell.volumes[i].material] -= cell.volumes[i].value;
        for (std::size_t j = 0; j < cell.volumes.size() && cell.volumes.size() > 1; ++j)
        {
          slopes(cell.volumes[i].material, cell.volumes[j].material) +=
            cell.slopes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
      }
    }
    const double scale = slopes.trace() / materialCount_;
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
    std::fill(changed_.begin(), changed_.end(), std::uint8_t{ 1 });
    update();
  }

  const CellComplex& complex_;
  MaterialValues& values_;
  std::vector<double> start_; ///< the values before the correction
  Progress& progress_;
  CellsAround around_;
  CellVolumes volumes_;
  std::vector<Request> requests_;
  std::vector<std::uint8_t> changed_, fixed_; ///< by vertex
  int materialCount_;
};
}

void correctVolumes(const CellComplex& complex, const GridTopology& topology, const Fractions& fractions,
  double minimumFraction, MaterialValues& values, Progress& progress)
{
  VolumeCorrection(complex, topology, fractions, minimumFraction, values, progress).run();
}
}
