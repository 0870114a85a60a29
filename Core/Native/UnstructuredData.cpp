#include "Native/UnstructuredData.h"

#include "Native/CellCentroids.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr int averageSize = 8;
/// Samples of a material are near a point within this many times their spacing, which is the distance from
/// the nearest of them to its own third neighbour. In cubes of samples, sqrt(3) reaches all that share one.
constexpr double nearSpacings = 1.5;
constexpr int spacingNeighbors = 4;
std::vector<SampleIndex> samplesOf(const SampleMaterials& materials, MaterialId m)
{
  std::vector<SampleIndex> result;
  for (Index sample = 0; sample < materials.size(); ++sample)
  {
    if (materials[sample].contains(m))
    {
      result.push_back(static_cast<SampleIndex>(sample));
    }
  }
  return result;
}

/// So large at a sample that the fit takes its value there.
double interpolationWeight(double relativeSquaredDistance)
{
  const double wide = relativeSquaredDistance + 0.1;
  return 1.0 / ((relativeSquaredDistance + 1e-12) * wide * wide);
}

/// No single sample must rule the slope with which a fit extrapolates far.
double extrapolationWeight(double relativeSquaredDistance)
{
  const double wide = relativeSquaredDistance + 0.3;
  return 1.0 / (wide * wide);
}

constexpr FitRule interpolation = { 16, interpolationWeight };
constexpr FitRule extrapolation = { 24, extrapolationWeight };
}

UnstructuredData::UnstructuredData(const Simulation& simulation, const NativeOptions& options, Progress& progress) :
  SampledData(simulation, options, progress)
{
  const auto& grid = std::get<UnstructuredGrid>(simulation.grid);
  for (const SampleGroup& group : groups())
  {
    Cloud cloud;
    cloud.points = group.association == Association::Cells ? cellCentroids(grid, progress) : grid.points;
    if (group.association == Association::Points)
    {
      cloud.cells = PointCells(grid, progress);
    }
    cloud.trees.resize(materials().size());
    tbb::parallel_for(std::size_t{ 0 }, cloud.trees.size(), [&](std::size_t m) {
      cloud.trees[m] =
        SampleTree(cloud.points, samplesOf(group.materials, MaterialId(static_cast<Index>(m))), progress);
    });
    clouds_.push_back(std::move(cloud));
  }
}

void UnstructuredData::positions(const SampleIndex* samples, Index count, Vector* result) const
{
  for (Index i = 0; i < count; ++i)
  {
    const std::size_t g = groupIndex(samples[i]);
    result[i] = clouds_[g].points[samples[i] - groups()[g].first];
  }
}

void UnstructuredData::evaluate(
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
    else if ((inside || method == GhostMethod::DataThenLinear) && interpolateInCell(g, m, point, result))
    {
      continue;
    }
    else if (!inside && method == GhostMethod::DataThenLinear && continueFromCell(g, m, point, closest, result))
    {
      continue;
    }
    else if (inside || (method == GhostMethod::DataThenLinear && sampleNear(g, m, point)))
    {
      interpolate(g, m, point, result);
    }
    else
    {
      extrapolate(g, m, point, closest, result);
    }
  }
}

bool UnstructuredData::sampleNear(std::size_t group, MaterialId m, const Vector& point) const
{
  const Cloud& cloud = clouds_[group];
  const SampleTree& tree = cloud.trees[static_cast<std::size_t>(m.value)];
  Neighbors nearest(1);
  tree.nearest(cloud.points, point, nearest);
  Neighbors round(spacingNeighbors);
  tree.nearest(cloud.points, cloud.points[nearest[0].sample], round);
  return nearest[0].squaredDistance <= nearSpacings * nearSpacings * round.farthest().squaredDistance;
}

void UnstructuredData::interpolate(std::size_t group, MaterialId m, const Vector& point, double* result) const
{
  addFitRound(group, m, { point, point }, interpolation, result);
}

void UnstructuredData::extrapolate(
  std::size_t group, MaterialId m, const Vector& point, const Vector& closest, double* result) const
{
  addFitRound(group, m, { closest, point }, extrapolation, result);
}

void UnstructuredData::average(std::size_t group, MaterialId m, const Vector& point, double* result) const
{
  const SampleGroup& samples = groups()[group];
  Neighbors neighbors(averageSize);
  clouds_[group].trees[static_cast<std::size_t>(m.value)].nearest(clouds_[group].points, point, neighbors);
  const double unit = neighbors.farthest().squaredDistance;
  std::array<double, averageSize> weights{};
  double sum = 0.0;
  for (int i = 0; i < neighbors.count; ++i)
  {
    const double weight = unit > 0.0 ? interpolationWeight(neighbors[i].squaredDistance / unit) : 1.0;
    weights[static_cast<std::size_t>(i)] = weight;
    sum += weight;
  }
  for (int i = 0; i < neighbors.count; ++i)
  {
    addSample(samples, m, samples.first + neighbors[i].sample, weights[static_cast<std::size_t>(i)] / sum, result);
  }
}

const PointCells* UnstructuredData::pointCells() const
{
  // Point samples come last.
  return clouds_.empty() || clouds_.back().cells.size() == 0 ? nullptr : &clouds_.back().cells;
}

NativeCellIndex UnstructuredData::nativeCellCount() const
{
  return pointCells() ? static_cast<NativeCellIndex>(pointCells()->size()) : 0;
}

void UnstructuredData::nativeCellBoxes(const NativeCellIndex* cells, Index count, Box* result) const
{
  for (Index i = 0; i < count; ++i)
  {
    result[i] = pointCells()->box(clouds_.back().points, cells[i]);
  }
}

NativeCell UnstructuredData::nativeCell(NativeCellIndex cell) const
{
  const SampleGroup& samples = groups().back();
  NativeCell result = pointCells()->nativeCell(clouds_.back().points, cell);
  for (std::size_t i = 0; i < 8; ++i)
  {
    const MaterialSet set = samples.materials[result.samples[i]];
    result.materials = i == 0 ? set : result.materials & set;
    result.samples[i] += samples.first;
  }
  return result;
}

bool UnstructuredData::interpolateInCell(std::size_t group, MaterialId m, const Vector& point, double* result) const
{
  const SampleGroup& samples = groups()[group];
  const Cloud& cloud = clouds_[group];
  PointCells::Weights weights;
  const Index cell = cloud.cells.cellAt(cloud.points, point, weights);
  if (cell < 0)
  {
    return false;
  }
  double missing = 0.0;
  Vector sum = Vector::Zero();
  bool anyOfMaterial = false;
  for (int i = 0; i < cloud.cells.cornerCount(cell); ++i)
  {
    const double weight = weights[static_cast<std::size_t>(i)];
    const std::uint32_t corner = cloud.cells.corner(cell, i);
    const bool counts = samples.materials[corner].contains(m);
    anyOfMaterial = anyOfMaterial || counts;
    missing += counts ? 0.0 : weight;
    sum += counts ? Vector(Vector::Zero()) : Vector(weight * cloud.points[corner]);
  }
  if (!anyOfMaterial)
  {
    return false;
  }
  for (int i = 0; i < cloud.cells.cornerCount(cell); ++i)
  {
    const std::uint32_t corner = cloud.cells.corner(cell, i);
    if (samples.materials[corner].contains(m))
    {
      addSample(samples, m, samples.first + corner, weights[static_cast<std::size_t>(i)], result);
    }
  }
  if (missing > 0.0)
  {
    addFitRound(group, m, { point, sum / missing, missing }, interpolation, result);
  }
  return true;
}

bool UnstructuredData::continueFromCell(
  std::size_t group, MaterialId m, const Vector& point, const Vector& closest, double* result) const
{
  PointCells::Weights weights;
  if (clouds_[group].cells.cellAt(clouds_[group].points, point, weights) >= 0 ||
      !interpolateInCell(group, m, closest, result))
  {
    return false;
  }
  addFitRound(group, m, { closest, point }, extrapolation, result);
  addFitRound(group, m, { closest, closest, -1.0 }, extrapolation, result);
  return true;
}

void UnstructuredData::addFitRound(
  std::size_t group, MaterialId m, const FitPlace& place, const FitRule& rule, double* result) const
{
  const SampleGroup& samples = groups()[group];
  const Cloud& cloud = clouds_[group];
  for (int size = rule.size;; size = std::min(2 * size, Neighbors::capacity))
  {
    Neighbors neighbors(size);
    cloud.trees[static_cast<std::size_t>(m.value)].nearest(cloud.points, place.origin, neighbors);
    const double unit = neighbors.farthest().squaredDistance;
    if (unit == 0.0 || (neighbors[0].squaredDistance == 0.0 && place.origin == place.target))
    {
      addSample(samples, m, samples.first + neighbors[0].sample, place.factor, result);
      return;
    }
    FitSamples near;
    for (int i = 0; i < neighbors.count; ++i)
    {
      const Vector offset = (cloud.points[neighbors[i].sample] - place.origin) / std::sqrt(unit);
      near.add(samples.first + neighbors[i].sample, offset, rule.weight(offset.squaredNorm()));
    }
    const LinearFit fit(near);
    if (fit.rank() == 3 || !neighbors.full() || size == Neighbors::capacity)
    {
      addFit(samples, m, near, fit, (place.target - place.origin) / std::sqrt(unit), place.factor, result);
      return;
    }
  }
}
}
