#include "Native/RectilinearData.h"

#include <algorithm>

namespace strata
{
namespace
{
/// Half the width, in samples, of the block of samples that a linear function is fitted to; the second one
/// where the first doesn't spread in all directions.
constexpr Index fitRadius = 2;
constexpr Index wideFitRadius = 3;

SampleLattice latticeOf(const RectilinearGrid& grid, Association association)
{
  SampleLattice result;
  result.coordinates = grid.coordinates;
  if (association == Association::Cells)
  {
    for (std::vector<double>& axis : result.coordinates)
    {
      for (std::size_t i = 0; i + 1 < axis.size(); ++i)
      {
        axis[i] = 0.5 * (axis[i] + axis[i + 1]);
      }
      axis.pop_back();
    }
  }
  return result;
}

/// A coordinate between two neighbours of a lattice's list: at lower + fraction (upper - lower). Beyond the ends
/// of the list the fraction is negative or above 1.
struct Interval
{
  Index lower = 0;
  double fraction = 0.0;
};

Interval intervalAt(const std::vector<double>& coordinates, double x)
{
  const auto count = static_cast<Index>(coordinates.size());
  if (count == 1)
  {
    return {};
  }
  const Index upper = std::upper_bound(coordinates.begin(), coordinates.end(), x) - coordinates.begin();
  const Index lower = std::clamp<Index>(upper - 1, 0, count - 2);
  const double start = coordinates[static_cast<std::size_t>(lower)];
  return { lower, (x - start) / (coordinates[static_cast<std::size_t>(lower) + 1] - start) };
}

/// The corners of the lattice cell round a point, with the weights of multilinear interpolation. Corners of
/// weight 0 are left out, so that a sample's own position needs no other sample.
class Corners
{
public:
  Corners(const SampleLattice& lattice, const Vector& point, bool withinLattice)
  {
    std::array<Interval, 3> intervals;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      intervals[axis] = intervalAt(lattice.coordinates[axis], point[static_cast<Index>(axis)]);
      if (withinLattice)
      {
        intervals[axis].fraction = std::clamp(intervals[axis].fraction, 0.0, 1.0);
      }
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      add(intervals, corner);
    }
  }

  struct Corner
  {
    SampleLattice::Position position;
    double weight = 0.0;
  };
  const Corner* begin() const { return corners_.data(); }
  const Corner* end() const { return corners_.data() + count_; }

private:
  void add(const std::array<Interval, 3>& intervals, int corner)
  {
    Corner& result = corners_[static_cast<std::size_t>(count_)];
    result.weight = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const bool upper = ((corner >> axis) & 1) != 0;
      result.position[axis] = intervals[axis].lower + (upper ? 1 : 0);
      result.weight *= upper ? intervals[axis].fraction : 1.0 - intervals[axis].fraction;
    }
    count_ += result.weight != 0.0 ? 1 : 0;
  }

  std::array<Corner, 9> corners_;
  int count_ = 0;
};

/// The lattice position nearest to a point along each axis.
SampleLattice::Position nearestPosition(const SampleLattice& lattice, const Vector& point)
{
  SampleLattice::Position result{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Interval interval = intervalAt(lattice.coordinates[axis], point[static_cast<Index>(axis)]);
    result[axis] = interval.lower + (interval.fraction > 0.5 ? 1 : 0);
  }
  return result;
}

/// Distance between samples at a position, along each axis: the unit in which a fit measures, so that
/// stretched cells weigh like cubes.
Vector spacingAt(const SampleLattice& lattice, const SampleLattice::Position& position)
{
  Vector result = Vector::Ones();
  for (int axis = 0; axis < 3; ++axis)
  {
    const Index lower = std::max<Index>(position[static_cast<std::size_t>(axis)] - 1, 0);
    const Index upper = std::min<Index>(position[static_cast<std::size_t>(axis)] + 1, lattice.count(axis) - 1);
    if (upper > lower)
    {
      result[axis] =
        (lattice.coordinate(axis, upper) - lattice.coordinate(axis, lower)) / static_cast<double>(upper - lower);
    }
  }
  return result;
}

/// Weight in a fit that interpolates: so large at a sample that the fit takes its value there.
double interpolationWeight(double squaredDistance)
{
  const double wide = squaredDistance + 0.3;
  return 1.0 / ((squaredDistance + 1e-6) * wide * wide);
}

/// Weight in a fit that extrapolates far: no single sample must rule its slope.
double extrapolationWeight(double squaredDistance)
{
  const double wide = squaredDistance + 1.0;
  return 1.0 / (wide * wide);
}
}

RectilinearData::RectilinearData(const Simulation& simulation, const NativeOptions& options, Progress& progress) :
  SampledData(simulation, options, progress)
{
  const auto& grid = std::get<RectilinearGrid>(simulation.grid);
  for (const SampleGroup& group : groups())
  {
    SampleLattice lattice = latticeOf(grid, group.association);
    SampleBlocks blocks(lattice, group.materials, progress);
    layouts_.push_back({ std::move(lattice), std::move(blocks) });
  }
}

void RectilinearData::positions(const SampleIndex* samples, Index count, Vector* result) const
{
  for (Index i = 0; i < count; ++i)
  {
    const std::size_t g = groupIndex(samples[i]);
    const SampleLattice& lattice = layouts_[g].lattice;
    result[i] = lattice.point(lattice.position(samples[i] - groups()[g].first));
  }
}

void RectilinearData::evaluate(
  MaterialId m, const Vector& point, bool inside, const Vector& closest, GhostMethod method, double* result) const
{
  for (std::size_t g = 0; g < groups().size(); ++g)
  {
    if (!groups()[g].materials.present().contains(m))
    {
      setUnknown(groups()[g], result);
      continue;
    }
    setZero(groups()[g], m, result);
    if (!inside && method == GhostMethod::Constant)
    {
      average(g, m, closest, result);
    }
    else if ((inside || method == GhostMethod::DataThenLinear) && sampleNear(g, m, point))
    {
      interpolate(g, m, point, result);
    }
    else
    {
      extrapolate(g, m, point, inside ? point : closest, result);
    }
  }
}

/// Whether m has a sample at a corner of a lattice cell that the point touches.
bool RectilinearData::sampleNear(std::size_t group, MaterialId m, const Vector& point) const
{
  const SampleLattice& lattice = layouts_[group].lattice;
  const SampleMaterials& materials = groups()[group].materials;
  Position begin{};
  Position end{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Interval interval = intervalAt(lattice.coordinates[axis], point[static_cast<Index>(axis)]);
    const Index last = lattice.count(static_cast<int>(axis)) - 1;
    begin[axis] = std::max<Index>(interval.lower - (interval.fraction == 0.0 ? 1 : 0), 0);
    end[axis] = std::min(interval.lower + 1, last);
  }
  bool found = false;
  forEachPosition(
    begin, end, [&](const Position& position) { found = found || materials[lattice.index(position)].contains(m); });
  return found;
}

void RectilinearData::interpolate(std::size_t group, MaterialId m, const Vector& point, double* result) const
{
  const SampleGroup& samples = groups()[group];
  const SampleLattice& lattice = layouts_[group].lattice;
  const Corners corners(lattice, point, false);
  const bool complete = std::all_of(corners.begin(), corners.end(),
    [&](const Corners::Corner& corner) { return samples.materials[lattice.index(corner.position)].contains(m); });
  if (!complete)
  {
    addFitRound(group, m, { nearestPosition(lattice, point), point, point, interpolationWeight }, result);
    return;
  }
  for (const Corners::Corner& corner : corners)
  {
    const auto sample = static_cast<SampleIndex>(lattice.index(corner.position));
    addSample(samples, m, samples.first + sample, corner.weight, result);
  }
}

void RectilinearData::average(std::size_t group, MaterialId m, const Vector& point, double* result) const
{
  const SampleGroup& samples = groups()[group];
  const SampleLattice& lattice = layouts_[group].lattice;
  const Corners corners(lattice, point, true);
  double sum = 0.0;
  for (const Corners::Corner& corner : corners)
  {
    sum += samples.materials[lattice.index(corner.position)].contains(m) ? corner.weight : 0.0;
  }
  if (sum == 0.0)
  {
    const Index nearest = layouts_[group].blocks.nearest(lattice, samples.materials, m, point);
    addSample(samples, m, samples.first + static_cast<SampleIndex>(nearest), 1.0, result);
    return;
  }
  for (const Corners::Corner& corner : corners)
  {
    const Index sample = lattice.index(corner.position);
    if (samples.materials[sample].contains(m))
    {
      addSample(samples, m, samples.first + static_cast<SampleIndex>(sample), corner.weight / sum, result);
    }
  }
}

void RectilinearData::extrapolate(
  std::size_t group, MaterialId m, const Vector& point, const Vector& closest, double* result) const
{
  const Layout& layout = layouts_[group];
  const FitPlace place = { nearestPosition(layout.lattice, closest), closest, point, extrapolationWeight };
  if (!addFitRound(group, m, place, result))
  {
    const Index nearest = layout.blocks.nearest(layout.lattice, groups()[group].materials, m, closest);
    const Position position = layout.lattice.position(nearest);
    addFitRound(group, m, { position, layout.lattice.point(position), point, extrapolationWeight }, result);
  }
}

bool RectilinearData::addFitRound(std::size_t group, MaterialId m, const FitPlace& place, double* result) const
{
  const Vector spacing = spacingAt(layouts_[group].lattice, place.center);
  const Vector target = (place.target - place.origin).cwiseQuotient(spacing);
  for (const Index radius : { fitRadius, wideFitRadius })
  {
    FitSamples samples;
    collect(group, m, place, spacing, radius, samples);
    if (samples.count == 0)
    {
      continue;
    }
    const LinearFit fit(samples);
    if (fit.rank() == 3 || radius == wideFitRadius)
    {
      addFit(groups()[group], m, samples, fit, target, result);
      return true;
    }
  }
  return false;
}

void RectilinearData::collect(std::size_t group, MaterialId m, const FitPlace& place, const Vector& spacing,
  Index radius, FitSamples& samples) const
{
  const SampleLattice& lattice = layouts_[group].lattice;
  const SampleMaterials& materials = groups()[group].materials;
  Position begin{};
  Position end{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    begin[axis] = std::max<Index>(place.center[axis] - radius, 0);
    end[axis] = std::min<Index>(place.center[axis] + radius, lattice.count(static_cast<int>(axis)) - 1);
  }
  forEachPosition(begin, end, [&](const Position& position) {
    const Index sample = lattice.index(position);
    if (materials[sample].contains(m))
    {
      const Vector offset = (lattice.point(position) - place.origin).cwiseQuotient(spacing);
      samples.add(groups()[group].first + static_cast<SampleIndex>(sample), offset, place.weight(offset.squaredNorm()));
    }
  });
}
}
