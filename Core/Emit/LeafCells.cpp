#include "Emit/LeafCells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <limits>

namespace strata
{
namespace
{
/// Enough subtrees to keep all threads busy, few enough to be found at once.
constexpr std::size_t subtreeCount = 512;
constexpr std::size_t verticesPerBlock = 65536;

bool isLeaf(const Hierarchy& hierarchy, const Level& level, CellId cell)
{
  return !level.isActive(hierarchy.cell(cell).diamond);
}

/// Cells of the level, or split cells above it, in tree order.
std::vector<CellId> subtrees(const Hierarchy& hierarchy, const Level& level)
{
  std::vector<CellId> cells;
  for (Index c = 0; c < hierarchy.rootCount; ++c)
  {
    cells.push_back(CellId(c));
  }
  for (std::size_t before = 0; before != cells.size() && cells.size() < subtreeCount;)
  {
    before = cells.size();
    std::vector<CellId> next;
    for (const CellId c : cells)
    {
      if (isLeaf(hierarchy, level, c))
      {
        next.push_back(c);
        continue;
      }
      const CellId child = hierarchy.cell(c).firstChild;
      next.push_back(child);
      next.push_back(CellId(child.value + 1));
    }
    cells.swap(next);
  }
  return cells;
}

void appendLeaves(const Hierarchy& hierarchy, const Level& level, CellId top, std::vector<CellId>& leaves)
{
  std::vector<CellId> stack = { top };
  while (!stack.empty())
  {
    const CellId c = stack.back();
    stack.pop_back();
    if (isLeaf(hierarchy, level, c))
    {
      leaves.push_back(c);
      continue;
    }
    const CellId child = hierarchy.cell(c).firstChild;
    stack.push_back(CellId(child.value + 1));
    stack.push_back(child);
  }
}

using FirstUse = std::atomic<std::uint32_t>;
constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

void lower(FirstUse& value, std::uint32_t candidate)
{
  std::uint32_t current = value.load(std::memory_order_relaxed);
  while (candidate < current && !value.compare_exchange_weak(current, candidate, std::memory_order_relaxed))
  {}
}

VertexId cornerAt(const Hierarchy& hierarchy, const std::vector<CellId>& cells, std::size_t use)
{
  return hierarchy.cell(cells[use / 4]).corners[use % 4];
}

/// Calls body(block, begin, end) for blocks of uses of vertices, in parallel.
template<typename Body>
void forUseBlocks(std::size_t uses, const Body& body)
{
  const std::size_t blocks = (uses + verticesPerBlock - 1) / verticesPerBlock;
  tbb::parallel_for(std::size_t{ 0 }, blocks,
    [&](std::size_t b) { body(b, b * verticesPerBlock, std::min(uses, (b + 1) * verticesPerBlock)); });
}
}

std::vector<CellId> leafCells(const Hierarchy& hierarchy, const Level& level)
{
  const std::vector<CellId> tops = subtrees(hierarchy, level);
  std::vector<std::vector<CellId>> leaves(tops.size());
  tbb::parallel_for(
    std::size_t{ 0 }, tops.size(), [&](std::size_t i) { appendLeaves(hierarchy, level, tops[i], leaves[i]); });
  std::vector<CellId> result;
  result.reserve(static_cast<std::size_t>(level.cellCount));
  for (const std::vector<CellId>& part : leaves)
  {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

VertexNumbering numberVertices(const Hierarchy& hierarchy, const std::vector<CellId>& cells)
{
  const std::size_t uses = 4 * cells.size();
  std::vector<FirstUse> firstUse(hierarchy.vertices.size());
  const auto useOf = [&](std::size_t use) -> FirstUse& {
    return firstUse[static_cast<std::size_t>(cornerAt(hierarchy, cells, use).value)];
  };
  tbb::parallel_for(
    tbb::blocked_range<std::size_t>(0, firstUse.size()), [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t v = range.begin(); v < range.end(); ++v)
      {
        firstUse[v].store(unused, std::memory_order_relaxed);
      }
    });
  forUseBlocks(uses, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t use = begin; use < end; ++use)
    {
      lower(useOf(use), static_cast<std::uint32_t>(use));
    }
  });
  std::vector<std::size_t> offsets(uses / verticesPerBlock + 2, 0);
  forUseBlocks(uses, [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t use = begin; use < end; ++use)
    {
      offsets[block + 1] += useOf(use) == use ? 1 : 0;
    }
  });
  for (std::size_t b = 1; b < offsets.size(); ++b)
  {
    offsets[b] += offsets[b - 1];
  }
  VertexNumbering result;
  result.numberOf.assign(hierarchy.vertices.size(), -1);
  result.vertices.resize(offsets.back());
  forUseBlocks(uses, [&](std::size_t block, std::size_t begin, std::size_t end) {
    std::size_t number = offsets[block];
    for (std::size_t use = begin; use < end; ++use)
    {
      if (useOf(use) == use)
      {
        const VertexId vertex = cornerAt(hierarchy, cells, use);
        result.numberOf[static_cast<std::size_t>(vertex.value)] = static_cast<std::int32_t>(number);
        result.vertices[number++] = vertex;
      }
    }
  });
  return result;
}
}
