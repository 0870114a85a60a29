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
    const Index cells = std::max<Index>(lattice.count(0) - 1, 0) * std::max<Index>(lattice.count(1) - 1, 0) *
                        std::max<Index>(lattice.count(2) - 1, 0);
    const NativeCellIndex first = nativeCellCount();
    layouts_.push_back({ std::move(lattice), std::move(blocks), first, static_cast<NativeCellIndex>(cells) });
  }
}

NativeCellIndex RectilinearData::nativeCellCount() const
{
  return layouts_.empty() ? 0 : layouts_.back().firstCell + layouts_.back().cellCount;
}

std::pair<std::size_t, RectilinearData::Position> RectilinearData::placeOf(NativeCellIndex cell) const
{
  const std::size_t group = layouts_.size() > 1 && cell >= layouts_[1].firstCell ? 1 : 0;
  const SampleLattice& lattice = layouts_[group].lattice;
  const Index i = static_cast<Index>(cell) - layouts_[group].firstCell;
  const Index row = i / (lattice.count(0) - 1);
  return { group, { i % (lattice.count(0) - 1), row % (lattice.count(1) - 1), row / (lattice.count(1) - 1) } };
}

void RectilinearData::nativeCellBoxes(const NativeCellIndex* cells, Index count, Box* result) const
{
  for (Index i = 0; i < count; ++i)
  {
    const auto [group, p] = placeOf(cells[i]);
    const SampleLattice& lattice = layouts_[group].lattice;
    result[i].lower = lattice.point(p);
    result[i].upper = lattice.point({ p[0] + 1, p[1] + 1, p[2] + 1 });
  }
}

NativeCell RectilinearData::nativeCell(NativeCellIndex cell) const
{
  const auto [group, lowest] = placeOf(cell);
  const SampleLattice& lattice = layouts_[group].lattice;
  const SampleMaterials& materials = groups()[group].materials;
  NativeCell result;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    Position p = lowest;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      p[axis] += static_cast<Index>((corner >> axis) & 1);
    }
    const Index sample = lattice.index(p);
    result.samples[corner] = groups()[group].first + static_cast<SampleIndex>(sample);
    result.corners[corner] = lattice.point(p);
    result.materials = corner == 0 ? materials[sample] : result.materials & materials[sample];
  }
  return result;
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
  // Beyond the lattice some weights are negative; a linear fit takes each sign's corners together, at their mean.
  std::array<double, 2> missing = { 0.0, 0.0 };
  std::array<Vector, 2> sum = { Vector::Zero(), Vector::Zero() };
  for (const LatticeCorners::Corner& corner : LatticeCorners(lattice, point, false))
  {
    const Index sample = lattice.index(corner.position);
    if (samples.materials[sample].contains(m))
    {
      addSample(samples, m, samples.first + static_cast<SampleIndex>(sample), corner.weight, result);
      continue;
    }
    const std::size_t sign = corner.weight < 0.0 ? 1 : 0;
    missing[sign] += corner.weight;
    sum[sign] += corner.weight * lattice.point(corner.position);
  }
  for (std::size_t sign = 0; sign < 2; ++sign)
  {
    if (missing[sign] != 0.0)
    {
      const FitPlace place = { nearestPosition(lattice, point), point, sum[sign] / missing[sign], interpolationWeight };
      addFitRound(group, m, place, 0, missing[sign], result);
    }
  }
}

void RectilinearData::average(std::size_t group, MaterialId m, const Vector& point, double* result) const
{
  const SampleGroup& samples = groups()[group];
  const SampleLattice& lattice = layouts_[group].lattice;
  const LatticeCorners corners(lattice, point, true);
  double sum = 0.0;
  for (const LatticeCorners::Corner& corner : corners)
  {
    sum += samples.materials[lattice.index(corner.position)].contains(m) ? corner.weight : 0.0;
  }
  if (sum == 0.0)
  {
    const Index nearest = layouts_[group].blocks.nearest(lattice, samples.materials, m, point);
    addSample(samples, m, samples.first + static_cast<SampleIndex>(nearest), 1.0, result);
    return;
  }
  for (const LatticeCorners::Corner& corner : corners)
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
  if (!addFitRound(group, m, place, 3, 1.0, result))
  {
    // The closest point may be some cells away from the samples, and a few of them don't tell all slopes.
    const Index nearest = layout.blocks.nearest(layout.lattice, groups()[group].materials, m, closest);
    const Position position = layout.lattice.position(nearest);
    addFitRound(group, m, { position, layout.lattice.point(position), point, extrapolationWeight }, 0, 1.0, result);
  }
}

bool RectilinearData::addFitRound(
  std::size_t group, MaterialId m, const FitPlace& place, int smallestRank, double factor, double* result) const
{
  // In units of the cells, so that stretched ones weigh like cubes.
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
    if (fit.rank() == 3 || (radius == wideFitRadius && fit.rank() >= smallestRank))
    {
      addFit(groups()[group], m, samples, fit, target, factor, result);
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
