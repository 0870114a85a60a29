#include "Select/Front.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
/// Diamonds that a task looks at; results are joined in the order of the tasks.
constexpr std::size_t diamondsPerBlock = 512;
}

Front::Front(const Hierarchy& hierarchy) : cellCount_(hierarchy.rootCount) {}

bool Front::activateParents(const Hierarchy& hierarchy, DiamondId id)
{
  bool allActive = true;
  for (const DiamondId parent : hierarchy.diamond(id).parents)
  {
    allActive = allActive && (!parent.valid() || isActive(parent) || activate(hierarchy, parent));
  }
  return allActive;
}

bool Front::activateParents(const Hierarchy& hierarchy, const LatticePoint& center)
{
  bool allActive = true;
  for (const LatticePoint& parent : hierarchy.lattice.parents(center))
  {
    const DiamondId id = hierarchy.diamondAt(parent);
    // A diamond none of whose cells exist yet: its own parents come first.
    const bool isActiveNow = id.valid() ? activate(hierarchy, id) : activateParents(hierarchy, parent) && false;
    allActive = isActiveNow && allActive;
  }
  return allActive;
}

bool Front::activate(const Hierarchy& hierarchy, DiamondId id)
{
  std::uint8_t& state = active_[static_cast<std::size_t>(id.value)];
  if (state != inactive)
  {
    return state == active;
  }
  const bool isBuilt = hierarchy.isSplit(id);
  const bool parentsActive =
    isBuilt ? activateParents(hierarchy, id) : activateParents(hierarchy, hierarchy.diamond(id).center);
  if (!parentsActive)
  {
    return false;
  }
  state = isBuilt ? active : missing;
  (isBuilt ? splitLast_ : missing_).push_back(id);
  return isBuilt;
}

void Front::forgetMissing(const Hierarchy& hierarchy)
{
  active_.resize(hierarchy.diamonds.size(), inactive);
  for (const DiamondId id : missing_)
  {
    active_[static_cast<std::size_t>(id.value)] = inactive;
  }
  missing_.clear();
}

std::vector<DiamondId> Front::split(const Hierarchy& hierarchy, const std::vector<CellId>& cells)
{
  forgetMissing(hierarchy);
  for (const CellId c : cells)
  {
    activate(hierarchy, hierarchy.cell(c).diamond);
  }
  for (const DiamondId id : splitLast_)
  {
    hierarchy.forCellsOf(id, [&](CellId) { ++cellCount_; });
  }
  splitLast_.clear();
  return missing_;
}

void Front::look(
  const Hierarchy& hierarchy, const Criterion& criterion, double scale, CellId cell, Findings& found) const
{
  const HierarchyCell& tetrahedron = hierarchy.cell(cell);
  if (isActive(tetrahedron.diamond))
  {
    return;
  }
  const float ratio = criterion.ratio(hierarchy, cell);
  if (criterion.mustSplit(tetrahedron, ratio, scale))
  {
    found.tooCoarse.push_back(cell);
  }
  else
  {
    found.resting.push_back({ cell, ratio });
  }
}

void Front::keep(const std::vector<Findings>& blocks)
{
  for (const Findings& found : blocks)
  {
    resting_.insert(resting_.end(), found.resting.begin(), found.resting.end());
    tooCoarse_.insert(tooCoarse_.end(), found.tooCoarse.begin(), found.tooCoarse.end());
    cellCount_ += found.cellCount;
  }
}

void Front::lookAtChildren(const Hierarchy& hierarchy, const Criterion& criterion, double scale)
{
  std::vector<Findings> blocks((splitLast_.size() + diamondsPerBlock - 1) / diamondsPerBlock);
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(), [&](std::size_t block) {
    const std::size_t end = std::min(splitLast_.size(), (block + 1) * diamondsPerBlock);
    for (std::size_t i = block * diamondsPerBlock; i < end; ++i)
    {
      hierarchy.forCellsOf(splitLast_[i], [&](CellId c) {
        const CellId child = hierarchy.cell(c).firstChild;
        look(hierarchy, criterion, scale, child, blocks[block]);
        look(hierarchy, criterion, scale, CellId(child.value + 1), blocks[block]);
        ++blocks[block].cellCount;
      });
    }
  });
  splitLast_.clear();
  keep(blocks);
}

void Front::wake(const Hierarchy& hierarchy, const Criterion& criterion, double scale)
{
  const auto asleep = std::remove_if(resting_.begin(), resting_.end(), [&](const RestingCell& resting) {
    const HierarchyCell& cell = hierarchy.cell(resting.cell);
    const bool split = isActive(cell.diamond);
    const bool awake = !split && criterion.mustSplit(cell, resting.ratio, scale);
    if (awake)
    {
      tooCoarse_.push_back(resting.cell);
    }
    return split || awake;
  });
  resting_.erase(asleep, resting_.end());
}

std::vector<DiamondId> Front::advance(
  const Hierarchy& hierarchy, const Criterion& criterion, double scale, Index maximumNumberOfCells)
{
  forgetMissing(hierarchy);
  if (!begun_)
  {
    std::vector<Findings> base(1);
    for (Index c = 0; c < hierarchy.rootCount; ++c)
    {
      look(hierarchy, criterion, scale, CellId(c), base.front());
    }
    keep(base);
    begun_ = true;
  }
  else if (waiting_.empty())
  {
    wake(hierarchy, criterion, scale);
  }
  tooCoarse_.insert(tooCoarse_.end(), waiting_.begin(), waiting_.end());
  waiting_.clear();
  while (!tooCoarse_.empty() && cellCount_ <= maximumNumberOfCells)
  {
    for (const CellId c : tooCoarse_)
    {
      if (!activate(hierarchy, hierarchy.cell(c).diamond))
      {
        waiting_.push_back(c);
      }
    }
    tooCoarse_.clear();
    lookAtChildren(hierarchy, criterion, scale);
  }
  return missing_;
}

bool Front::meetsBounds(const Hierarchy& hierarchy) const
{
  return std::none_of(resting_.begin(), resting_.end(), [&](const RestingCell& resting) {
    return resting.ratio > 1.0f && !isActive(hierarchy.cell(resting.cell).diamond);
  });
}

Level Front::level(const Hierarchy& hierarchy) const
{
  Level level;
  level.cellCount = cellCount_;
  level.active.resize(hierarchy.diamonds.size(), 0);
  std::transform(active_.begin(), active_.end(), level.active.begin(),
    [](std::uint8_t state) { return static_cast<std::uint8_t>(state == active ? 1 : 0); });
  return level;
}
}
