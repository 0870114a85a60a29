#include "Emit/LevelCells.h"

#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <limits>

namespace strata
{
namespace
{
/// Enough subtrees to keep all threads busy, few enough to be found at once.
constexpr std::size_t subtreeCount = 512;
constexpr std::size_t usesPerBlock = 65536;

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
  // One cell waits for each level above the one in hand, and bisection ends after three times the octaves.
  std::array<CellId, 3 * Lattice::octaves + 2> stack;
  std::size_t waiting = 0;
  stack[waiting++] = top;
  while (waiting > 0)
  {
    const CellId c = stack[--waiting];
    if (isLeaf(hierarchy, level, c))
    {
      leaves.push_back(c);
      continue;
    }
    const CellId child = hierarchy.cell(c).firstChild;
    stack[waiting++] = CellId(child.value + 1);
    stack[waiting++] = child;
  }
}

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

/// What is gathered at a vertex of the hierarchy: threads may meet there, and no order of theirs shows.
struct VertexUse
{
  std::atomic<std::uint64_t> needs{ 0 };
  std::atomic<std::uint32_t> first{ unused };
  std::int32_t number = -1;

  void need(std::uint64_t materials)
  {
    if ((needs.load(std::memory_order_relaxed) & materials) != materials)
    {
      needs.fetch_or(materials, std::memory_order_relaxed);
    }
  }
  void use(std::uint32_t at)
  {
    std::uint32_t current = first.load(std::memory_order_relaxed);
    while (at < current && !first.compare_exchange_weak(current, at, std::memory_order_relaxed))
    {}
  }
};

/// One gathering of a level's cells.
class Gatherer
{
public:
  Gatherer(const Hierarchy& hierarchy, const Level& level, Progress& progress) :
    hierarchy_(hierarchy), progress_(progress), uses_(hierarchy.vertices.size())
  {
    result_.cells = leafCells(hierarchy, level);
    result_.tetrahedra = Buffer<std::int64_t>(static_cast<Index>(4 * result_.cells.size()));
  }

  LevelCells run(const std::vector<ExtraValues>& extra)
  {
    gatherCorners();
    numberVertices();
    for (const ExtraValues& values : extra)
    {
      result_.needs[useOf(values.vertex.value).number].insert(values.material);
    }
    return std::move(result_);
  }

private:
  /// Calls body(block, begin, end) for blocks of uses of vertices by cells, in parallel.
  template<typename Body>
  void forUseBlocks(const Body& body)
  {
    const std::size_t uses = 4 * result_.cells.size();
    const std::size_t blocks = (uses + usesPerBlock - 1) / usesPerBlock;
    tbb::parallel_for(std::size_t{ 0 }, blocks, [&](std::size_t b) {
      progress_.check();
      body(b, b * usesPerBlock, std::min(uses, (b + 1) * usesPerBlock));
    });
  }

  VertexUse& useOf(std::int64_t vertex) { return uses_[static_cast<std::size_t>(vertex)]; }
  VertexUse& useOfCorner(std::size_t use) { return useOf(result_.tetrahedra[static_cast<Index>(use)]); }

  void gatherCorners()
  {
    forUseBlocks([&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t use = begin; use < end; use += 4)
      {
        const CellId id = result_.cells[use / 4];
        const HierarchyCell& cell = hierarchy_.cell(id);
        std::array<VertexId, 4> corners = cell.corners;
        if (cell.inverted)
        {
          std::swap(corners[2], corners[3]);
        }
        const std::uint64_t held = hierarchy_.materialsOf(id).bits();
        for (std::size_t k = 0; k < 4; ++k)
        {
          result_.tetrahedra[static_cast<Index>(use + k)] = corners[k].value;
          useOf(corners[k].value).need(held);
          useOf(corners[k].value).use(static_cast<std::uint32_t>(use + k));
        }
      }
    });
  }

  void numberVertices()
  {
    std::vector<std::size_t> offsets(4 * result_.cells.size() / usesPerBlock + 2, 0);
    forUseBlocks([&](std::size_t block, std::size_t begin, std::size_t end) {
      for (std::size_t use = begin; use < end; ++use)
      {
        offsets[block + 1] += useOfCorner(use).first == use ? 1 : 0;
      }
    });
    for (std::size_t b = 1; b < offsets.size(); ++b)
    {
      offsets[b] += offsets[b - 1];
    }
    result_.vertices.resize(offsets.back());
    result_.needs.resize(offsets.back());
    forUseBlocks([&](std::size_t block, std::size_t begin, std::size_t end) {
      for (std::size_t use = begin, number = offsets[block]; use < end; ++use)
      {
        VertexUse& vertex = useOfCorner(use);
        if (vertex.first == use)
        {
          vertex.number = static_cast<std::int32_t>(number);
          result_.vertices[number] = VertexId(result_.tetrahedra[static_cast<Index>(use)]);
          result_.needs[number++] = MaterialSet::fromBits(vertex.needs);
        }
      }
    });
    forUseBlocks([&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t use = begin; use < end; ++use)
      {
        result_.tetrahedra[static_cast<Index>(use)] = useOfCorner(use).number;
      }
    });
  }

  const Hierarchy& hierarchy_;
  Progress& progress_;
  std::vector<VertexUse> uses_; ///< [hierarchy vertex]
  LevelCells result_;
};
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

LevelCells levelCells(const Hierarchy& hierarchy, const Level& level, Progress& progress)
{
  return Gatherer(hierarchy, level, progress).run(level.extra);
}
}
