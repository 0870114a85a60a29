#include "Extract/SmearedFractions.h"

#include "Extract/ForEach.h"
#include "Extract/PassOn.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// What the fractions are mixed more than the regions of the interface, over its area and the cell's size, half-way up
/// the cells that it crosses: data below the first are sharp, above the second smeared. Codes that track interfaces
/// give 0.00, labels that were averaged over cells 0.05, codes that transport fractions 0.12 to 0.2.
constexpr double sharpExcess = 0.06;
constexpr double smearedExcess = 0.1;
/// How often what cells lack is passed on: once to the interface, then along it, for the interface is to move smoothly.
constexpr int passes = 4;

/// Leads of a vertex' fractions over the next: below the first distances count, above the second fractions.
constexpr double smallLead = 0.2;
constexpr double largeLead = 0.5;

/// The largest value at a vertex less the second.
double leadAt(const MaterialValues& values, std::int32_t v)
{
  double first = 0.0;
  double second = 0.0;
  for (Index i = values.start[v]; i < values.start[v + 1]; ++i)
  {
    const double value = values.values[i];
    second = std::max(second, std::min(first, value));
    first = std::max(first, value);
  }
  return first - second;
}

/// How mixed shares are: 0 for one material, 1 for two halves.
double mixture(const std::vector<Share>& shares, double total)
{
  double squares = 0.0;
  for (const Share& share : shares)
  {
    squares += share.value * share.value;
  }
  return 2.0 * (1.0 - squares / (total * total));
}

struct Mixing
{
  double excess = 0.0;
  double area = 0.0;

  Mixing& operator+=(const Mixing& other)
  {
    excess += other.excess;
    area += other.area;
    return *this;
  }
};

/// Sums over the cells round each cell, those that share more nodes counting more.
void spread(const MixedRegion& region, std::vector<Mixing>& mixing, Progress& progress)
{
  const CellsAround& around = region.around;
  std::vector<Mixing> atNodes(static_cast<std::size_t>(region.complex.nodeCount()));
  forEach(region.complex.nodeCount(), progress, [&](std::int32_t v) {
    for (std::int32_t i = around.start[v]; i < around.start[v + 1]; ++i)
    {
      atNodes[v] += mixing[around.cells[i]];
    }
  });
  forEach(region.complex.cellCount(), progress, [&](std::int32_t c) {
    mixing[c] = {};
    for (std::int32_t i = around.nodeStart[c]; i < around.nodeStart[c + 1]; ++i)
    {
      mixing[c] += atNodes[around.nodes[i]];
    }
  });
}

/// The value half-way up; 0 if there is none.
double medianOf(std::vector<double>& values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
}

SmearedFractions::SmearedFractions(const MixedRegion& region, const CellVolumes& volumes, Progress& progress) :
  region_(region), volumes_(volumes)
{
  const CellComplex& complex = region.complex;
  std::vector<Mixing> mixing(complex.cells.size());
  forEach(complex.cellCount(), progress, [&](std::int32_t c) {
    const CellVolume& cell = volumes_[c];
    mixing[c].excess = (mixture(given(c), cell.total) - mixture(cell.volumes, cell.total)) * cell.total;
    mixing[c].area = cell.volumes.size() > 1 ? cell.slopes.trace() * std::cbrt(cell.total) : 0.0;
  });
  for (int pass = 0; pass < 2; ++pass)
  {
    spread(region, mixing, progress);
  }
  std::vector<double> excesses;
  for (std::int32_t c = 0; c < complex.cellCount(); ++c)
  {
    if (volumes_[c].volumes.size() > 1 && mixing[c].area > 0.0)
    {
      excesses.push_back(mixing[c].excess / mixing[c].area);
    }
  }
  degree_ = std::clamp((medianOf(excesses) - sharpExcess) / (smearedExcess - sharpExcess), 0.0, 1.0);
}

void SmearedFractions::clearOffInterface(MaterialValues& values, Progress& progress) const
{
  const MaterialValues fractions = makeMaterialValues(region_.complex, region_.fractions, progress);
  forEach(region_.complex.vertexCount(), progress, [&](std::int32_t v) {
    const double part = degree_ * std::clamp((leadAt(fractions, v) - smallLead) / (largeLead - smallLead), 0.0, 1.0);
    for (Index i = values.start[v]; i < values.start[v + 1]; ++i)
    {
      const double value = (1.0 - 2.0 * fractions.values[i]) * values.absent[v];
      values.values[i] += part * (value - values.values[i]);
    }
  });
}

std::vector<Share> SmearedFractions::given(std::int32_t cell) const
{
  std::vector<Share> shares;
  region_.fractions.volumesOfCell(region_.complex.cells[cell], volumes_[cell].total, shares);
  return shares;
}

std::vector<std::vector<Share>> SmearedFractions::targets(Progress& progress) const
{
  std::vector<std::vector<Share>> lacking(region_.complex.cells.size());
  forEach(region_.complex.cellCount(), progress, [&](std::int32_t c) {
    lacking[c] = given(c);
    for (const Share& volume : volumes_[c].volumes)
    {
      addTo(lacking[c], volume.material, -volume.value);
    }
  });
  PassOn passOn(region_.around, volumes_);
  for (int pass = 0; pass < passes; ++pass)
  {
    std::vector<std::vector<Share>> received(lacking.size());
    for (std::int32_t c = 0; c < region_.complex.cellCount(); ++c)
    {
      progress.check();
      passOn.give(c, lacking[c], received);
    }
    lacking.swap(received);
  }
  forEach(region_.complex.cellCount(), progress, [&](std::int32_t c) { addVolumes(c, lacking[c]); });
  return lacking;
}

void SmearedFractions::addVolumes(std::int32_t cell, std::vector<Share>& lacking) const
{
  for (const Share& volume : volumes_[cell].volumes)
  {
    addTo(lacking, volume.material, volume.value);
  }
  for (Share& share : lacking)
  {
    share.value *= degree_;
  }
  for (const Share& share : given(cell))
  {
    addTo(lacking, share.material, (1.0 - degree_) * share.value);
  }
  double sum = 0.0;
  for (Share& share : lacking)
  {
    share.value = std::max(0.0, share.value);
    sum += share.value;
  }
  for (Share& share : lacking)
  {
    share.value *= volumes_[cell].total / sum;
  }
  std::sort(lacking.begin(), lacking.end(), [](const Share& a, const Share& b) { return a.material < b.material; });
}
}
