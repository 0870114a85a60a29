#include "Build/DepthFirst.h"

#include <algorithm>
#include <array>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<std::size_t>;
/// Cells between two looks at the progress, in loops over them.
constexpr std::size_t checkEvery = 1 << 16;

std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& order)
{
  std::vector<std::int32_t> result(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    result[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
  }
  return result;
}

template<typename Tag>
Id<Tag> moved(Id<Tag> id, const std::vector<std::int32_t>& newPlace)
{
  return id.valid() ? Id<Tag>(newPlace[static_cast<std::size_t>(id.value)]) : id;
}

/// Ids in the order of their first use.
struct FirstUses
{
  explicit FirstUses(std::size_t count) : known(count, 0) { order.reserve(count); }
  void use(std::int32_t id)
  {
    std::uint8_t& isKnown = known[static_cast<std::size_t>(id)];
    if (!isKnown)
    {
      order.push_back(id);
    }
    isKnown = 1;
  }

  std::vector<std::int32_t> order;
  std::vector<std::uint8_t> known;
};

/// Brings the values of vertices into the order of the vertices, which have been reordered.
void reorderValues(Hierarchy& hierarchy)
{
  std::vector<Index> oldOffsets(hierarchy.vertices.size());
  oldOffsets.swap(hierarchy.valueOffsets);
  Index end = 0;
  for (std::size_t v = 0; v < oldOffsets.size(); ++v)
  {
    hierarchy.valueOffsets[v] = end;
    end += hierarchy.vertexMaterials[v].size() * hierarchy.valuesPerMaterial;
  }
  std::vector<float> values(hierarchy.values.size());
  tbb::parallel_for(Range(0, oldOffsets.size(), 4096), [&](const Range& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v)
    {
      const int count = hierarchy.vertexMaterials[v].size() * hierarchy.valuesPerMaterial;
      std::copy_n(hierarchy.values.begin() + oldOffsets[v], count, values.begin() + hierarchy.valueOffsets[v]);
    }
  });
  hierarchy.values.swap(values);
}

/// Appends what is below a cell.
void appendDescendants(const Hierarchy& hierarchy, CellId top, std::vector<std::int32_t>& cells, Progress& progress)
{
  std::array<CellId, 3 * Lattice::octaves + 2> stack;
  std::size_t waiting = 0;
  stack[waiting++] = top;
  while (waiting > 0)
  {
    if (cells.size() % checkEvery < 2)
    {
      progress.check();
    }
    const CellId child = hierarchy.cell(stack[--waiting]).firstChild;
    if (child.valid())
    {
      cells.push_back(child.value);
      cells.push_back(child.value + 1);
      stack[waiting++] = CellId(child.value + 1);
      stack[waiting++] = child;
    }
  }
}
}

HierarchyOrder depthFirst(const Hierarchy& hierarchy, Progress& progress)
{
  HierarchyOrder order;
  order.cells.reserve(hierarchy.cells.size());
  for (Index root = 0; root < hierarchy.rootCount; ++root)
  {
    order.cells.push_back(static_cast<std::int32_t>(root));
  }
  for (Index root = 0; root < hierarchy.rootCount; ++root)
  {
    appendDescendants(hierarchy, CellId(root), order.cells, progress);
  }
  FirstUses diamonds(hierarchy.diamonds.size());
  FirstUses vertices(hierarchy.vertices.size());
  for (std::size_t i = 0; i < order.cells.size(); ++i)
  {
    if (i % checkEvery == 0)
    {
      progress.check();
    }
    const HierarchyCell& cell = hierarchy.cell(CellId(order.cells[i]));
    diamonds.use(cell.diamond.value);
    for (const VertexId corner : cell.corners)
    {
      vertices.use(corner.value);
    }
  }
  order.diamonds = std::move(diamonds.order);
  order.vertices = std::move(vertices.order);
  return order;
}

void reorder(Hierarchy& hierarchy, const HierarchyOrder& order, Progress& progress)
{
  const std::vector<std::int32_t> newCell = inverse(order.cells);
  const std::vector<std::int32_t> newDiamond = inverse(order.diamonds);
  const std::vector<std::int32_t> newVertex = inverse(order.vertices);
  progress.check();
  reorder(hierarchy.cells, order.cells);
  reorder(hierarchy.cellMaterials, order.cells);
  reorder(hierarchy.interfaceErrors, order.cells);
  reorder(hierarchy.fieldErrors, order.cells, hierarchy.fields.size());
  progress.check();
  reorder(hierarchy.diamonds, order.diamonds);
  hierarchy.table.renumber(newDiamond);
  progress.check();
  reorder(hierarchy.vertices, order.vertices);
  reorder(hierarchy.vertexMaterials, order.vertices);
  reorder(hierarchy.valueOffsets, order.vertices);
  reorderValues(hierarchy);
  progress.check();
  tbb::parallel_for(Range(0, hierarchy.cells.size(), 4096), [&](const Range& range) {
    for (std::size_t c = range.begin(); c < range.end(); ++c)
    {
      HierarchyCell& cell = hierarchy.cells[c];
      for (VertexId& corner : cell.corners)
      {
        corner = moved(corner, newVertex);
      }
      cell.diamond = moved(cell.diamond, newDiamond);
      cell.firstChild = moved(cell.firstChild, newCell);
      cell.nextInDiamond = moved(cell.nextInDiamond, newCell);
    }
  });
  tbb::parallel_for(Range(0, hierarchy.diamonds.size(), 4096), [&](const Range& range) {
    for (std::size_t d = range.begin(); d < range.end(); ++d)
    {
      Diamond& diamond = hierarchy.diamonds[d];
      diamond.firstCell = moved(diamond.firstCell, newCell);
      diamond.vertex = moved(diamond.vertex, newVertex);
      for (DiamondId& parent : diamond.parents)
      {
        parent = moved(parent, newDiamond);
      }
    }
  });
}
}
