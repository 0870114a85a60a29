#include "Contour/Contour.h"

#include "Geometry/CutPolygon.h"
#include "Model/CellDistances.h"
#include "Model/Errors.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<Index>;
/// Cells per task; results are joined in the order of the tasks' cells.
constexpr Index cellsPerBlock = 2048;

/// What a thread needs to cut cells.
struct Workspace
{
  PolygonCut cut;
  std::vector<CornerValues> distances;
};

/// The zero sets of (field - value), material by material.
struct Contoured
{
  const Representation& representation;
  const std::vector<const float*>& fields; ///< [material]
  const std::vector<double>& values;
  MaterialSet materials;
};

void checkInput(const Representation& representation, FieldId field, const std::vector<double>& values)
{
  if (field.value < 0 || field.value >= static_cast<std::int64_t>(representation.fields.size()))
  {
    throw InvalidInput("there is no field " + std::to_string(field.value) + " to contour; the representation has " +
                       std::to_string(representation.fields.size()));
  }
  const Field& chosen = representation.fields[static_cast<std::size_t>(field.value)];
  if (chosen.components != 1)
  {
    throw InvalidInput("the field '" + chosen.name + "' has " + std::to_string(chosen.components) +
                       " components; a contour needs a scalar");
  }
  for (const double value : values)
  {
    if (!std::isfinite(value))
    {
      throw InvalidInput("the value " + std::to_string(value) + " of a contour of '" + chosen.name + "' is not finite");
    }
  }
}

/// Field minus value at a cell's corners. Returns whether it changes its sign; never where a corner has no value, for
/// then the material has no part in the cell.
bool crosses(
  const float* field, double value, const std::array<std::int64_t, 4>& vertices, std::array<double, 4>& differences)
{
  int positives = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    differences[corner] = static_cast<double>(field[vertices[corner]]) - value;
    if (std::isnan(differences[corner]))
    {
      return false;
    }
    positives += differences[corner] >= 0.0 ? 1 : 0;
  }
  return positives > 0 && positives < 4;
}

/// Adds the polygon of one region of a cut section. `surface` is the number of the value.
void addPolygon(
  const PolygonCut& cut, const PolygonCut::Region& region, std::size_t surface, Index cell, PolygonUses& result)
{
  const int owner = static_cast<int>(surface) * MaterialSet::capacity + region.function;
  for (int i = region.begin; i < region.end; ++i)
  {
    result.corners.push_back({ cut.points()[cut.loops()[i]], owner });
  }
  result.ends.push_back(static_cast<std::int64_t>(result.corners.size()));
  result.material.push_back(region.function);
  result.cell.push_back(cell);
}

void contourMaterial(const Contoured& contoured, MaterialId m, Index cell, Workspace& workspace, PolygonUses& result)
{
  const std::array<std::int64_t, 4> vertices = verticesOfCell(contoured.representation, cell);
  const float* field = contoured.fields[static_cast<std::size_t>(m.value)];
  std::array<double, 4> differences;
  for (std::size_t surface = 0; surface < contoured.values.size(); ++surface)
  {
    if (!field || !crosses(field, contoured.values[surface], vertices, differences))
    {
      continue;
    }
    if (workspace.distances.empty())
    {
      distancesOfCell(contoured.representation, cell, workspace.distances);
    }
    PolygonCut& cut = workspace.cut;
    cut.cutSection(vertices, differences, workspace.distances.data(), static_cast<int>(workspace.distances.size()));
    for (const PolygonCut::Region& region : cut.regions())
    {
      if (region.function == m.value)
      {
        addPolygon(cut, region, surface, cell, result);
      }
    }
  }
}
}

MaterialPolygons contour(const Representation& representation, FieldId field, const std::vector<double>& values,
  MaterialSet materials, Progress& progress)
{
  checkInput(representation, field, values);
  const Contoured contoured{ representation, representation.values[static_cast<std::size_t>(field.value)], values,
    materials };
  const Index blockCount = (representation.cellCount + cellsPerBlock - 1) / cellsPerBlock;
  std::vector<PolygonUses> blocks(static_cast<std::size_t>(blockCount));
  tbb::enumerable_thread_specific<Workspace> workspaces;
  tbb::parallel_for(Range(0, blockCount, 1), [&](const Range& range) {
    Workspace& workspace = workspaces.local();
    for (Index block = range.begin(); block != range.end(); ++block)
    {
      progress.check();
      const Index end = std::min(representation.cellCount, (block + 1) * cellsPerBlock);
      for (Index cell = block * cellsPerBlock; cell < end; ++cell)
      {
        workspace.distances.clear();
        for (const MaterialId m : materials)
        {
          contourMaterial(contoured, m, cell, workspace, blocks[block]);
        }
      }
    }
  });
  progress.update(0.7);
  MaterialPolygons result = sharePolygons(representation, joinPolygons(blocks));
  progress.update(1.0);
  return result;
}
}
