#include "Measure/MisclassifiedVolume.h"

#include "Measure/CellRegions.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata
{
namespace
{
constexpr Index cellsPerBlock = 512;
/// Points in all cells together, as long as each cell gets at least 2^3.
constexpr double pointsInAll = 1 << 19;
constexpr int fewestStrata = 2; ///< along each of the three axes
constexpr int mostStrata = 6;

/// A number in [0, 1) that is a function of a cell, a stratum and an axis (the finalizer of SplitMix64).
double jitter(Index cell, int stratum, int axis)
{
  std::uint64_t x = (static_cast<std::uint64_t>(cell) * 1024u + static_cast<std::uint64_t>(stratum)) * 3u +
                    static_cast<std::uint64_t>(axis) + 1u;
  x *= 0x9E3779B97F4A7C15ull;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
  x ^= x >> 31;
  return static_cast<double>(x >> 11) * 0x1.0p-53;
}

/// Maps the unit cube onto barycentric coordinates of a tetrahedron, equal volumes to equal volumes: the distribution
/// of the sorted coordinates' gaps is uniform.
std::array<double, 4> barycentric(std::array<double, 3> cube)
{
  std::sort(cube.begin(), cube.end());
  return { cube[0], cube[1] - cube[0], cube[2] - cube[1], 1.0 - cube[2] };
}

class Estimator
{
public:
  Estimator(const Representation& representation, const OriginalMaterial& original) :
    representation_(representation), original_(original)
  {}

  VolumeEstimate run(Progress& progress);

private:
  struct Sums
  {
    double volume = 0.0;
    double variance = 0.0;
    double nearGaps = 0.0;
  };

  /// Adds the cells that no interface meets; lists the others.
  Sums addExact(Index begin, Index end, std::vector<Index>& open) const;
  void addSampled(Index cell, int strata, Sums& sums) const;
  MaterialId representedAt(Index cell, MaterialSet candidates, const std::array<double, 4>& weights) const;
  Vector at(Index cell, const std::array<double, 4>& weights) const;
  bool isOnOneSide(Index cell, const OriginalMaterial::Answer& middle) const;

  const Representation& representation_;
  const OriginalMaterial& original_;
};

Vector Estimator::at(Index cell, const std::array<double, 4>& weights) const
{
  Vector result = Vector::Zero();
  for (int i = 0; i < 4; ++i)
  {
    result += weights[i] * representation_.point(representation_.tetrahedra[4 * cell + i]);
  }
  return result;
}

/// Whether the interfaces, which no point of the cell is on, give it one material: beside a gap they may not.
bool Estimator::isOnOneSide(Index cell, const OriginalMaterial::Answer& middle) const
{
  for (int i = 0; i < 4 && original_.hasGaps(); ++i)
  {
    const OriginalMaterial::Answer corner =
      original_.at(representation_.point(representation_.tetrahedra[4 * cell + i]));
    if (corner.material != middle.material || corner.nearGap != middle.nearGap)
    {
      return false;
    }
  }
  return true;
}

MaterialId Estimator::representedAt(Index cell, MaterialSet candidates, const std::array<double, 4>& weights) const
{
  MaterialId closest;
  double smallest = std::numeric_limits<double>::infinity();
  for (const MaterialId m : candidates)
  {
    double distance = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      distance +=
        weights[i] * static_cast<double>(representation_.distances[m.value][representation_.tetrahedra[4 * cell + i]]);
    }
    if (distance < smallest)
    {
      smallest = distance;
      closest = m;
    }
  }
  return closest;
}

Estimator::Sums Estimator::addExact(Index begin, Index end, std::vector<Index>& open) const
{
  Sums sums;
  CellRegions regions(representation_);
  OriginalMaterial::Ball ball;
  for (Index cell = begin; cell < end; ++cell)
  {
    const Vector center = at(cell, { 0.25, 0.25, 0.25, 0.25 });
    double radius = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      radius = std::max(radius, (representation_.point(representation_.tetrahedra[4 * cell + i]) - center).norm());
    }
    const OriginalMaterial::Answer truth = original_.at(center, radius, ball);
    if (truth.distance < radius || !isOnOneSide(cell, truth))
    {
      open.push_back(cell);
      continue;
    }
    const MaterialSet candidates = materialsOfCell(representation_, cell);
    if (candidates != MaterialSet::of(truth.material))
    {
      regions.divide(cell);
      const double right = regions.materials().contains(truth.material) ? regions.volume(truth.material) : 0.0;
      const double wrong = std::max(0.0, regions.cellVolume() - right);
      sums.volume += wrong;
      sums.nearGaps += truth.nearGap ? wrong : 0.0;
    }
  }
  return sums;
}

void Estimator::addSampled(Index cell, int strata, Sums& sums) const
{
  const MaterialSet candidates = materialsOfCell(representation_, cell);
  const int count = strata * strata * strata;
  int wrong = 0;
  int wrongNearGaps = 0;
  OriginalMaterial::Ball ball;
  for (int stratum = 0; stratum < count; ++stratum)
  {
    const std::array<int, 3> position = { stratum % strata, stratum / strata % strata, stratum / (strata * strata) };
    std::array<double, 3> cube{};
    for (int axis = 0; axis < 3; ++axis)
    {
      cube[axis] = (position[axis] + jitter(cell, stratum, axis)) / strata;
    }
    const std::array<double, 4> weights = barycentric(cube);
    const OriginalMaterial::Answer truth = original_.at(at(cell, weights), 0.0, ball);
    const bool isWrong = representedAt(cell, candidates, weights) != truth.material;
    wrong += isWrong ? 1 : 0;
    wrongNearGaps += isWrong && truth.nearGap ? 1 : 0;
  }
  CellRegions regions(representation_);
  regions.divide(cell);
  const double share = static_cast<double>(wrong) / count;
  sums.volume += share * regions.cellVolume();
  sums.nearGaps += regions.cellVolume() * wrongNearGaps / count;
  sums.variance += regions.cellVolume() * regions.cellVolume() * share * (1.0 - share) / (count - 1);
}

VolumeEstimate Estimator::run(Progress& progress)
{
  const auto blocksOf = [](Index items) {
    return static_cast<std::size_t>((items + cellsPerBlock - 1) / cellsPerBlock);
  };
  std::vector<Sums> exact(blocksOf(representation_.cellCount));
  std::vector<std::vector<Index>> openOfBlock(exact.size());
  tbb::parallel_for(std::size_t{ 0 }, exact.size(), [&](std::size_t block) {
    progress.check();
    const Index begin = static_cast<Index>(block) * cellsPerBlock;
    exact[block] = addExact(begin, std::min(begin + cellsPerBlock, representation_.cellCount), openOfBlock[block]);
  });
  std::vector<Index> open;
  for (const std::vector<Index>& cells : openOfBlock)
  {
    open.insert(open.end(), cells.begin(), cells.end());
  }
  progress.update(0.5);
  const double perCell = pointsInAll / std::max(1.0, static_cast<double>(open.size()));
  const int strata = std::clamp(static_cast<int>(std::cbrt(perCell)), fewestStrata, mostStrata);
  std::vector<Sums> sampled(open.size());
  tbb::parallel_for(std::size_t{ 0 }, open.size(), [&](std::size_t i) {
    progress.check();
    addSampled(open[i], strata, sampled[i]);
  });
  exact.insert(exact.end(), sampled.begin(), sampled.end());
  Sums total;
  for (const Sums& part : exact)
  {
    total.volume += part.volume;
    total.variance += part.variance;
    total.nearGaps += part.nearGaps;
  }
  return { total.volume, std::sqrt(total.variance), total.nearGaps };
}
}

VolumeEstimate misclassifiedVolume(
  const Representation& representation, const OriginalMaterial& original, Progress& progress)
{
  return Estimator(representation, original).run(progress);
}
}
