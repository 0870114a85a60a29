#include "Extract/CellVolumes.h"

#include "Extract/ForEach.h"

namespace strata
{
namespace
{
using Bits = std::uint64_t;

Bits bit(std::uint8_t material)
{
  return Bits{ 1 } << material;
}
}

CellVolumes::CellVolumes(
  const MixedRegion& region, const MaterialValues& values, double minimumFraction, Progress& progress) :
  complex_(region.complex),
  around_(region.around), values_(values), fractions_(region.fractions), minimumFraction_(minimumFraction),
  progress_(progress), winners_(static_cast<std::size_t>(complex_.vertexCount())), reach_(winners_.size()),
  cells_(complex_.cells.size()), replaced_(complex_.cells.size(), 0), workspaces_([this] {
    return Workspace{ CellCutter(complex_, values_, winners_), {} };
  })
{}

void CellVolumes::update(const std::vector<std::uint8_t>& changed)
{
  forEach(complex_.vertexCount(), progress_,
    [&](std::int32_t v) { winners_[v] = changed[v] ? values_.winner(v) : winners_[v]; });
  forEach(complex_.cellCount(), progress_, [&](std::int32_t cell) {
    bool dirty = false;
    around_.forEachVertex(complex_, cell, [&](std::int32_t v) { dirty = dirty || changed[v] != 0; });
    if (dirty)
    {
      measure(cell);
    }
  });
  forEach(complex_.vertexCount(), progress_, [&](std::int32_t v) {
    reach_[v] = 0;
    for (std::int32_t i = around_.start[v]; i < around_.start[v + 1]; ++i)
    {
      for (const Share& volume : cells_[around_.cells[i]].volumes)
      {
        reach_[v] |= volume.value > 0.0 ? bit(volume.material) : 0;
      }
    }
  });
  forEach(complex_.cellCount(), progress_, [this](std::int32_t cell) { findTargets(cell); });
}

void CellVolumes::replaceTargets(std::int32_t cell, std::vector<Share> targets)
{
  cells_[cell].targets = std::move(targets);
  replaced_[cell] = 1;
}

void CellVolumes::measure(std::int32_t cell)
{
  CellVolume& state = cells_[cell];
  Workspace& local = workspaces_.local();
  state.volumes.clear();
  const std::uint8_t only = local.cutter.only(cell);
  if (only != CellCutter::several && state.total > 0.0)
  {
    state.volumes.push_back({ only, state.total });
    return;
  }
  local.cutter.volumes(cell, local.regions);
  const CellCutter::Regions& regions = local.regions;
  state.total = regions.total;
  const std::size_t count = regions.materials.size();
  state.slopes.resize(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    state.volumes.push_back({ regions.materials[i], regions.volumes[i] });
    for (std::size_t j = 0; j < count; ++j)
    {
      state.slopes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = regions.derivatives[i * count + j];
    }
  }
}

void CellVolumes::findTargets(std::int32_t cell)
{
  CellVolume& state = cells_[cell];
  Bits reached = 0;
  around_.forEachVertex(complex_, cell, [&](std::int32_t v) { reached |= reach_[v]; });
  if (replaced_[cell] || reached == state.reached)
  {
    return;
  }
  state.reached = reached;
  fractions_.ofCell(complex_.cells[cell], state.targets);
  const std::size_t dominant = largest(state.targets);
  double sum = 0.0;
  for (std::size_t i = 0; i < state.targets.size(); ++i)
  {
    Share& share = state.targets[i];
    const bool kept = i == dominant || share.value >= minimumFraction_ || (reached & bit(share.material)) != 0;
    share.value = kept ? share.value : 0.0;
    sum += share.value;
  }
  for (Share& share : state.targets)
  {
    share.value *= state.total / sum;
  }
}
}
