#include "Extract/BalanceTotals.h"

#include <algorithm>

namespace strata
{
Eigen::VectorXd missingVolumes(const CellVolumes& volumes, std::int32_t cellCount, int materialCount)
{
  Eigen::VectorXd missing = Eigen::VectorXd::Zero(materialCount);
  for (std::int32_t c = 0; c < cellCount; ++c)
  {
    for (const Share& target : volumes[c].targets)
    {
      missing[target.material] += target.value;
    }
    for (const Share& volume : volumes[c].volumes)
    {
      missing[volume.material] -= volume.value;
    }
  }
  return missing;
}

Eigen::VectorXd droppedVolumes(const CellVolumes& volumes, const MixedRegion& region, Progress& progress)
{
  const CellComplex& complex = region.complex;
  const GridTopology& topology = region.topology;
  const Fractions& fractions = region.fractions;
  Eigen::VectorXd dropped = Eigen::VectorXd::Zero(fractions.materialCount());
  std::vector<Share> shares;
  std::vector<Share> targets;
  std::int32_t local = 0;
  for (Index cell = 0; cell < topology.cellCount(); ++cell)
  {
    if (cell % 4096 == 0)
    {
      progress.check();
    }
    const bool inComplex = local < complex.cellCount() && complex.cells[local] == cell;
    if (!topology.hidden(cell))
    {
      // Cells that are not cut go to their dominant material as a whole.
      const double total = inComplex ? volumes[local].total : topology.volume(cell);
      fractions.volumesOfCell(cell, total, shares);
      for (const Share& share : shares)
      {
        dropped[share.material] += share.value;
      }
      const std::size_t dominant = largest(shares);
      targets = inComplex ? volumes[local].targets : std::vector<Share>{ { shares[dominant].material, total } };
      for (const Share& target : targets)
      {
        dropped[target.material] -= target.value;
      }
    }
    local += inComplex ? 1 : 0;
  }
  return dropped;
}

Eigen::VectorXd rises(const CellVolumes& volumes, std::int32_t cellCount, const Eigen::VectorXd& wanted)
{
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(wanted.size(), wanted.size());
  for (std::int32_t c = 0; c < cellCount; ++c)
  {
    const std::vector<Share>& regions = volumes[c].volumes;
    for (std::size_t i = 0; i < regions.size() && regions.size() > 1; ++i)
    {
      for (std::size_t j = 0; j < regions.size(); ++j)
      {
        slopes(regions[i].material, regions[j].material) +=
          volumes[c].slopes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
    }
  }
  const double scale = slopes.trace() / static_cast<double>(wanted.size());
  if (scale <= 0.0)
  {
    return Eigen::VectorXd::Zero(wanted.size());
  }
  slopes.diagonal().array() += 1e-9 * scale;
  return slopes.ldlt().solve(wanted);
}
}
