#include "Native/UnstructuredData.h"

#include "Native/CellCentroids.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace strata
{
namespace
{
/// Numbers of nearest samples that a linear function is fitted to; the larger ones where fewer don't spread in
/// all directions.
constexpr std::array<int, 3> fitSizes = { 16, 32, 64 };
constexpr int averageSize = 8;
/// Samples of a material are near a point within this many times their spacing, which is the distance from
/// the nearest of them to its own third neighbour. In cubes of samples, sqrt(3) reaches all that share one.
constexpr double nearSpacings = 1.5;
constexpr int spacingNeighbors = 4;
/// Squared distance, relative to the farthest sample fitted, below which samples weigh the same.
constexpr double interpolationCore = 1e-12;
/// The same for extrapolation, where no single sample must rule.
constexpr double extrapolationCore = 0.1;

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

double interpolationWeight(double squaredDistance)
{
  return 1.0 / (squaredDistance + interpolationCore);
}

double extrapolationWeight(double squaredDistance)
{
  const double root = 1.0 / (squaredDistance + extrapolationCore);
  return root * root;
}
}

UnstructuredData::UnstructuredData(const Simulation& simulation, const NativeOptions& options, Progress& progress) :
  SampledData(simulation, options, progress)
{
  const auto& grid = std::get<UnstructuredGrid>(simulation.grid);
  for (const SampleGroup& group : groups())
  {
    Cloud cloud;
    cloud.points = group.association == Association::Cells ? cellCentroids(grid, progress) : grid.points;
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
  addFitRound(group, m, point, point, interpolationWeight, result);
}

void UnstructuredData::extrapolate(
  std::size_t group, MaterialId m, const Vector& point, const Vector& closest, double* result) const
{
  addFitRound(group, m, closest, point, extrapolationWeight, result);
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

template<typename Weight>
void UnstructuredData::addFitRound(std::size_t group, MaterialId m, const Vector& origin, const Vector& point,
  const Weight& weight, double* result) const
{
  const SampleGroup& samples = groups()[group];
  const Cloud& cloud = clouds_[group];
  for (const int size : fitSizes)
  {
    Neighbors neighbors(size);
    cloud.trees[static_cast<std::size_t>(m.value)].nearest(cloud.points, origin, neighbors);
    const double radius = std::sqrt(neighbors.farthest().squaredDistance);
    if (radius == 0.0 || (neighbors[0].squaredDistance == 0.0 && origin == point))
    {
      addSample(samples, m, samples.first + neighbors[0].sample, 1.0, result);
      return;
    }
    const FitSamples near = collect(group, neighbors, origin, radius, weight);
    const LinearFit fit(near);
    if (fit.rank() == 3 || !neighbors.full() || size == fitSizes.back())
    {
      addFit(samples, m, near, fit, (point - origin) / radius, result);
      return;
    }
  }
}

template<typename Weight>
FitSamples UnstructuredData::collect(
  std::size_t group, const Neighbors& neighbors, const Vector& origin, double radius, const Weight& weight) const
{
  FitSamples result;
  for (int i = 0; i < neighbors.count; ++i)
  {
    const Vector offset = (clouds_[group].points[neighbors[i].sample] - origin) / radius;
    result.add(groups()[group].first + neighbors[i].sample, offset, weight(offset.squaredNorm()));
  }
  return result;
}
}
