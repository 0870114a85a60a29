#include "Select/Front.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace strata
{
namespace
{
/// Enough to keep all threads busy, few enough to be found at once.
constexpr std::size_t enoughCells = 512;
/// Cells and diamonds per task; results are joined in the order of the tasks.
constexpr std::size_t cellsPerBlock = 64;
constexpr std::size_t diamondsPerBlock = 1024;

/// A look at a cell mostly waits for memory: so many cells are on their way at once.
constexpr std::size_t cellsInHand = 8;

std::size_t blockCount(std::size_t items, std::size_t itemsPerBlock)
{
  return (items + itemsPerBlock - 1) / itemsPerBlock;
}

template<typename T>
void append(std::vector<T>& all, const std::vector<T>& part)
{
  all.insert(all.end(), part.begin(), part.end());
}

/// Begins to fetch what tells whether a cell must be split, for a look at it a little later.
void prefetch(const Hierarchy& hierarchy, CellId id)
{
  const auto c = static_cast<std::size_t>(id.value);
  __builtin_prefetch(hierarchy.cells.data() + c);
  __builtin_prefetch(hierarchy.interfaceErrors.data() + c);
  __builtin_prefetch(hierarchy.fieldErrors.data() + c * hierarchy.fields.size());
}

/// Calls visit(CellId) for every cell of some diamonds: a cell of each in turn, and the next one is on its way
/// meanwhile.
template<typename Visit>
void forCellsInTurn(const Hierarchy& hierarchy, const DiamondId* diamonds, std::size_t count, const Visit& visit)
{
  std::array<CellId, cellsInHand> cells;
  std::size_t begun = 0;
  for (bool busy = true; busy;)
  {
    busy = false;
    for (CellId& cell : cells)
    {
      if (cell.valid())
      {
        visit(cell);
        cell = hierarchy.cell(cell).nextInDiamond;
      }
      else if (begun < count)
      {
        cell = hierarchy.diamond(diamonds[begun++]).firstCell;
      }
      if (cell.valid())
      {
        prefetch(hierarchy, cell);
        busy = true;
      }
    }
    busy = busy || begun < count;
  }
}
}

/// Cells that wait below a cell in hand.
class Front::CellStack
{
public:
  bool empty() const { return size_ == 0; }
  CellId top() const { return cells_[size_ - 1]; }
  void push(CellId cell) { cells_[size_++] = cell; }
  CellId pop() { return cells_[--size_]; }

private:
  /// One cell waits for each level above the one in hand, and bisection ends after three times the octaves.
  std::array<CellId, 3 * Lattice::octaves + 2> cells_;
  std::size_t size_ = 0;
};

Front::Front(const Hierarchy& hierarchy, bool resumable) : resumable_(resumable), cellCount_(hierarchy.rootCount) {}

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
    hierarchy.forCellsOf(id, [&](CellId c) {
      const CellId child = hierarchy.cell(c).firstChild;
      waiting_.push_back(child);
      waiting_.push_back(CellId(child.value + 1));
      ++cellCount_;
    });
  }
  splitLast_.clear();
  return missing_;
}

void Front::look(
  const Hierarchy& hierarchy, const Criterion& criterion, double scale, CellStack& stack, Findings& found) const
{
  const CellId id = stack.pop();
  const HierarchyCell& cell = hierarchy.cell(id);
  if (!criterion.mustSplit(hierarchy, id, scale))
  {
    if (resumable_)
    {
      found.resting.push_back({ id, criterion.ratio(hierarchy, id) });
    }
    return;
  }
  if (!isActive(cell.diamond))
  {
    found.tooCoarse.push_back(cell.diamond);
  }
  if (!cell.firstChild.valid())
  {
    found.waiting.push_back(id);
    return;
  }
  stack.push(CellId(cell.firstChild.value + 1));
  stack.push(cell.firstChild);
}

void Front::visitBelow(const Hierarchy& hierarchy, const Criterion& criterion, double scale, const CellId* tops,
  std::size_t count, Findings& found) const
{
  std::array<CellStack, cellsInHand> stacks;
  std::size_t begun = 0;
  for (bool busy = true; busy;)
  {
    busy = false;
    for (CellStack& stack : stacks)
    {
      if (stack.empty() && begun < count)
      {
        stack.push(tops[begun++]);
      }
      if (stack.empty())
      {
        continue;
      }
      busy = true;
      look(hierarchy, criterion, scale, stack, found);
      if (!stack.empty())
      {
        prefetch(hierarchy, stack.top());
      }
    }
  }
}

std::vector<CellId> Front::spread(
  const Hierarchy& hierarchy, const Criterion& criterion, double scale, std::vector<CellId> cells)
{
  for (std::size_t before = 0; before != cells.size() && cells.size() < enoughCells;)
  {
    before = cells.size();
    std::vector<CellId> next;
    for (const CellId id : cells)
    {
      const HierarchyCell& cell = hierarchy.cell(id);
      if (!cell.firstChild.valid() || !criterion.mustSplit(hierarchy, id, scale))
      {
        next.push_back(id);
        continue;
      }
      tooCoarse_.push_back(cell.diamond);
      next.push_back(cell.firstChild);
      next.push_back(CellId(cell.firstChild.value + 1));
    }
    cells.swap(next);
  }
  return cells;
}

void Front::visit(const Hierarchy& hierarchy, const Criterion& criterion, double scale, std::vector<CellId> cells)
{
  cells = spread(hierarchy, criterion, scale, std::move(cells));
  std::vector<Findings> blocks(blockCount(cells.size(), cellsPerBlock));
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(), [&](std::size_t block) {
    const std::size_t begin = block * cellsPerBlock;
    const std::size_t count = std::min(cells.size() - begin, cellsPerBlock);
    visitBelow(hierarchy, criterion, scale, cells.data() + begin, count, blocks[block]);
  });
  for (const Findings& found : blocks)
  {
    append(tooCoarse_, found.tooCoarse);
    append(waiting_, found.waiting);
    append(resting_, found.resting);
  }
}

std::vector<CellId> Front::splitTooCoarse(const Hierarchy& hierarchy, const Criterion& criterion, double scale)
{
  for (const DiamondId id : tooCoarse_)
  {
    activate(hierarchy, id);
  }
  tooCoarse_.clear();
  std::vector<std::vector<CellId>> children(blockCount(splitLast_.size(), diamondsPerBlock));
  std::vector<Index> counts(children.size(), 0);
  tbb::parallel_for(std::size_t{ 0 }, children.size(), [&](std::size_t block) {
    const std::size_t begin = block * diamondsPerBlock;
    const std::size_t count = std::min(splitLast_.size() - begin, diamondsPerBlock);
    forCellsInTurn(hierarchy, splitLast_.data() + begin, count, [&](CellId id) {
      const HierarchyCell& cell = hierarchy.cell(id);
      ++counts[block];
      if (!criterion.mustSplit(hierarchy, id, scale))
      {
        children[block].push_back(cell.firstChild);
        children[block].push_back(CellId(cell.firstChild.value + 1));
      }
    });
  });
  splitLast_.clear();
  std::vector<CellId> result;
  for (std::size_t block = 0; block < children.size(); ++block)
  {
    append(result, children[block]);
    cellCount_ += counts[block];
  }
  return result;
}

std::vector<CellId> Front::wake(const Hierarchy& hierarchy, const Criterion& criterion, double scale)
{
  std::vector<CellId> awake;
  const auto asleep = std::remove_if(resting_.begin(), resting_.end(), [&](const RestingCell& resting) {
    const HierarchyCell& cell = hierarchy.cell(resting.cell);
    const bool split = isActive(cell.diamond);
    if (!split && static_cast<double>(resting.ratio) > scale && criterion.mustSplit(hierarchy, resting.cell, scale))
    {
      awake.push_back(resting.cell);
      return true;
    }
    return split;
  });
  resting_.erase(asleep, resting_.end());
  return awake;
}

std::vector<DiamondId> Front::advance(
  const Hierarchy& hierarchy, const Criterion& criterion, double scale, Index maximumNumberOfCells)
{
  forgetMissing(hierarchy);
  std::vector<CellId> cells = std::move(waiting_);
  waiting_.clear();
  if (!begun_)
  {
    for (Index c = 0; c < hierarchy.rootCount; ++c)
    {
      cells.push_back(CellId(c));
    }
    begun_ = true;
  }
  else if (cells.empty())
  {
    cells = wake(hierarchy, criterion, scale);
  }
  while (!cells.empty() && cellCount_ <= maximumNumberOfCells)
  {
    visit(hierarchy, criterion, scale, std::move(cells));
    cells = splitTooCoarse(hierarchy, criterion, scale);
  }
  return missing_;
}

bool Front::meetsBounds(const Hierarchy& hierarchy) const
{
  assert(resumable_);
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
