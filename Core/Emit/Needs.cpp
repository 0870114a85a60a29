#include "Emit/Needs.h"

#include "Emit/LeafCells.h"
#include "Geometry/CutPolygon.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <tuple>

namespace strata
{
namespace
{
constexpr std::size_t cellsPerBlock = 4096;

template<typename Body>
void forCells(std::size_t count, const Body& body)
{
  tbb::parallel_for(std::size_t{ 0 }, (count + cellsPerBlock - 1) / cellsPerBlock, [&](std::size_t block) {
    for (std::size_t i = block * cellsPerBlock; i < std::min(count, (block + 1) * cellsPerBlock); ++i)
    {
      body(i);
    }
  });
}

/// The materials with a region on a face, among those with values at its three corners.
MaterialSet winnersOnFace(const Hierarchy& hierarchy, const Level& level, const std::array<VertexId, 3>& face,
  MaterialSet candidates, PolygonCut& cut)
{
  std::vector<CornerValues> functions;
  for (const MaterialId m : candidates)
  {
    CornerValues function{ m.value, { 0.0, 0.0, 0.0, 0.0 } };
    for (std::size_t k = 0; k < 3; ++k)
    {
      function.values[k] = static_cast<double>(*level.valuesOf(hierarchy, face[k], m));
    }
    functions.push_back(function);
  }
  cut.cutTriangle(
    { face[0].value, face[1].value, face[2].value }, functions.data(), static_cast<int>(functions.size()));
  MaterialSet winners;
  for (const PolygonCut::Region& region : cut.regions())
  {
    winners.insert(MaterialId(region.function));
  }
  return winners;
}
}

Needs::Needs(const Hierarchy& hierarchy, const Level& level, const std::vector<CellId>& cells) :
  bits_(hierarchy.vertices.size())
{
  forCells(cells.size(), [&](std::size_t i) {
    const std::uint64_t held = hierarchy.materialsOf(cells[i]).bits();
    for (const VertexId corner : hierarchy.cell(cells[i]).corners)
    {
      std::atomic<std::uint64_t>& bits = bits_[static_cast<std::size_t>(corner.value)];
      if ((bits.load(std::memory_order_relaxed) & held) != held)
      {
        bits.fetch_or(held, std::memory_order_relaxed);
      }
    }
  });
  for (const ExtraValues& extra : level.extra)
  {
    add(extra.vertex, extra.material);
  }
}

std::vector<MissingMaterial> missingMaterials(const Hierarchy& hierarchy, const Level& level, Progress& progress)
{
  const std::vector<CellId> cells = leafCells(hierarchy, level);
  const Needs needs(hierarchy, level, cells);
  tbb::enumerable_thread_specific<PolygonCut> cuts;
  tbb::enumerable_thread_specific<std::vector<MissingMaterial>> found;
  forCells(cells.size(), [&](std::size_t i) {
    const HierarchyCell& cell = hierarchy.cell(cells[i]);
    const MaterialSet known = needs.atAllCorners(cell);
    for (std::size_t skip = 0; skip < 4; ++skip)
    {
      const std::array<VertexId, 3> face = { cell.corners[(skip + 1) % 4], cell.corners[(skip + 2) % 4],
        cell.corners[(skip + 3) % 4] };
      const MaterialSet onFace = needs.at(face[0]) & needs.at(face[1]) & needs.at(face[2]);
      if (onFace == known)
      {
        continue;
      }
      progress.check();
      for (const MaterialId m : winnersOnFace(hierarchy, level, face, onFace, cuts.local()) - known)
      {
        found.local().push_back({ cell.corners[skip], m });
      }
    }
  });
  std::vector<MissingMaterial> result;
  for (const std::vector<MissingMaterial>& part : found)
  {
    result.insert(result.end(), part.begin(), part.end());
  }
  const auto key = [](const MissingMaterial& m) { return std::make_tuple(m.vertex.value, m.material.value); };
  std::sort(
    result.begin(), result.end(), [&](const MissingMaterial& a, const MissingMaterial& b) { return key(a) < key(b); });
  result.erase(std::unique(result.begin(), result.end(),
                 [&](const MissingMaterial& a, const MissingMaterial& b) { return key(a) == key(b); }),
    result.end());
  return result;
}
}
