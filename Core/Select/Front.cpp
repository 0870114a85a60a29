#include "Select/Front.h"

#include <algorithm>

namespace strata
{
Front::Front(const Hierarchy& hierarchy) : cellCount_(hierarchy.rootCount)
{
  for (Index c = 0; c < hierarchy.rootCount; ++c)
  {
    pending_.push_back(CellId(c));
  }
}

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
  if (active_[static_cast<std::size_t>(id.value)] != inactive)
  {
    return isActive(id);
  }
  const bool isBuilt = hierarchy.isSplit(id);
  const bool parentsActive =
    isBuilt ? activateParents(hierarchy, id) : activateParents(hierarchy, hierarchy.diamond(id).center);
  if (!parentsActive)
  {
    return false;
  }
  if (!isBuilt)
  {
    active_[static_cast<std::size_t>(id.value)] = missing;
    missing_.push_back(id);
    return false;
  }
  active_[static_cast<std::size_t>(id.value)] = active;
  hierarchy.forCellsOf(id, [&](CellId c) {
    const CellId child = hierarchy.cell(c).firstChild;
    pending_.push_back(child);
    pending_.push_back(CellId(child.value + 1));
    ++cellCount_;
  });
  return true;
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
  resting_.insert(resting_.end(), pending_.begin(), pending_.end());
  pending_.clear();
  return missing_;
}

std::vector<DiamondId> Front::advance(
  const Hierarchy& hierarchy, const Criterion& criterion, double scale, Index maximumNumberOfCells)
{
  forgetMissing(hierarchy);
  pending_.insert(pending_.end(), waiting_.begin(), waiting_.end());
  waiting_.clear();
  if (pending_.empty())
  {
    pending_.swap(resting_);
  }
  while (!pending_.empty() && cellCount_ <= maximumNumberOfCells)
  {
    const CellId c = pending_.back();
    pending_.pop_back();
    const DiamondId diamond = hierarchy.cell(c).diamond;
    if (isActive(diamond))
    {
      continue;
    }
    if (!criterion.mustSplit(hierarchy, c, scale))
    {
      resting_.push_back(c);
    }
    else if (!activate(hierarchy, diamond))
    {
      waiting_.push_back(c);
    }
  }
  return missing_;
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
