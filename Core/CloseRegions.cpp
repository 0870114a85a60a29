#include "CloseRegions.h"

#include "Emit/MissingMaterials.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <tuple>

namespace strata
{
namespace
{
/// The values that the vertices lack, as they would be if a cell round them held the material.
std::vector<ExtraValues> extraValues(
  const HierarchyBuilder& builder, const std::vector<MissingMaterial>& missing, Progress& progress)
{
  std::vector<ExtraValues> extra(missing.size());
  tbb::parallel_for(std::size_t{ 0 }, missing.size(), [&](std::size_t i) {
    progress.check();
    extra[i] = { missing[i].vertex, missing[i].material, builder.valuesAt(missing[i].vertex, missing[i].material) };
  });
  return extra;
}
}

void closeRegions(
  const HierarchyBuilder& builder, const Hierarchy& values, Level& level, LevelCells& cells, Progress& progress)
{
  std::vector<std::uint8_t> changed;
  for (;;)
  {
    const std::vector<MissingMaterial> missing = missingMaterials(values, level, cells, changed, progress);
    if (missing.empty())
    {
      return;
    }
    changed.assign(cells.vertices.size(), 0);
    for (const MissingMaterial& m : missing)
    {
      cells.needs[static_cast<std::size_t>(m.number)].insert(m.material);
      changed[static_cast<std::size_t>(m.number)] = 1;
    }
    std::vector<ExtraValues> extra = extraValues(builder, missing, progress);
    const auto known = static_cast<std::ptrdiff_t>(level.extra.size());
    level.extra.insert(level.extra.end(), std::make_move_iterator(extra.begin()), std::make_move_iterator(extra.end()));
    std::inplace_merge(level.extra.begin(), level.extra.begin() + known, level.extra.end(),
      [](const ExtraValues& a, const ExtraValues& b) {
        return std::tie(a.vertex, a.material) < std::tie(b.vertex, b.material);
      });
  }
}
}
