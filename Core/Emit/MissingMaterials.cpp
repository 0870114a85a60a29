#include "Emit/MissingMaterials.h"

#include "Geometry/CutPolygon.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <tuple>

namespace strata
{
namespace
{
constexpr std::size_t cellsPerBlock = 4096;

/// What a thread needs to look at cells, and what it found.
struct Workspace
{
  PolygonCut cut;
  std::vector<CornerValues> functions;
  std::vector<MissingMaterial> found;
};

/// False only if another material is nearer at all three corners of a face, hence everywhere on it.
bool mayWin(MaterialId m, const std::vector<CornerValues>& functions)
{
  const auto own = std::find_if(
    functions.begin(), functions.end(), [&](const CornerValues& function) { return function.function == m.value; });
  return std::none_of(functions.begin(), functions.end(), [&](const CornerValues& other) {
    return std::equal(other.values.begin(), other.values.begin() + 3, own->values.begin(), std::less<double>());
  });
}

/// Those of `wanted` that have a region on a face, among the candidates, which have values at its three corners.
MaterialSet winnersOnFace(const Hierarchy& hierarchy, const Level& level, const std::array<VertexId, 3>& face,
  MaterialSet candidates, MaterialSet wanted, Workspace& workspace)
{
  std::vector<CornerValues>& functions = workspace.functions;
  functions.clear();
  for (const MaterialId m : candidates)
  {
    CornerValues function{ m.value, { 0.0, 0.0, 0.0, 0.0 } };
    for (std::size_t k = 0; k < 3; ++k)
    {
      function.values[k] = static_cast<double>(*level.valuesOf(hierarchy, face[k], m));
    }
    functions.push_back(function);
  }
  MaterialSet winners;
  for (const MaterialId m : wanted)
  {
    if (!mayWin(m, functions))
    {
      wanted.erase(m);
    }
  }
  if (wanted.empty())
  {
    return winners;
  }
  workspace.cut.cutTriangle(
    { face[0].value, face[1].value, face[2].value }, functions.data(), static_cast<int>(functions.size()));
  for (const PolygonCut::Region& region : workspace.cut.regions())
  {
    winners.insert(MaterialId(region.function));
  }
  return winners & wanted;
}

void lookAtCell(
  const Hierarchy& hierarchy, const Level& level, const LevelCells& cells, std::size_t cell, Workspace& workspace)
{
  const std::int64_t* corners = cells.tetrahedra.data() + 4 * cell;
  const MaterialSet known = cells.atAllCorners(cell);
  for (std::size_t skip = 0; skip < 4; ++skip)
  {
    const std::array<std::int64_t, 3> face = { corners[(skip + 1) % 4], corners[(skip + 2) % 4],
      corners[(skip + 3) % 4] };
    const MaterialSet onFace = cells.needs[face[0]] & cells.needs[face[1]] & cells.needs[face[2]];
    if (onFace == known)
    {
      continue;
    }
    const std::array<VertexId, 3> vertices = { cells.vertices[face[0]], cells.vertices[face[1]],
      cells.vertices[face[2]] };
    for (const MaterialId m : winnersOnFace(hierarchy, level, vertices, onFace, onFace - known, workspace))
    {
      workspace.found.push_back({ cells.vertices[corners[skip]], corners[skip], m });
    }
  }
}
}

std::vector<MissingMaterial> missingMaterials(const Hierarchy& hierarchy, const Level& level, const LevelCells& cells,
  const std::vector<std::uint8_t>& changed, Progress& progress)
{
  const auto concerns = [&](std::size_t cell) {
    const std::int64_t* corners = cells.tetrahedra.data() + 4 * cell;
    return changed.empty() || changed[corners[0]] || changed[corners[1]] || changed[corners[2]] || changed[corners[3]];
  };
  tbb::enumerable_thread_specific<Workspace> workspaces;
  const std::size_t count = cells.cells.size();
  tbb::parallel_for(std::size_t{ 0 }, (count + cellsPerBlock - 1) / cellsPerBlock, [&](std::size_t block) {
    progress.check();
    Workspace& workspace = workspaces.local();
    for (std::size_t i = block * cellsPerBlock; i < std::min(count, (block + 1) * cellsPerBlock); ++i)
    {
      if (concerns(i))
      {
        lookAtCell(hierarchy, level, cells, i, workspace);
      }
    }
  });
  std::vector<MissingMaterial> result;
  for (const Workspace& workspace : workspaces)
  {
    result.insert(result.end(), workspace.found.begin(), workspace.found.end());
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
