#include "Select/Saturate.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// Errors by criterion: the interface's first, then one per field.
struct ErrorTable
{
  std::size_t criteria = 0;
  std::vector<float> errors;

  float* of(std::int32_t id) { return errors.data() + static_cast<std::size_t>(id) * criteria; }
};

/// The diamonds of a level, finest first.
std::vector<DiamondId> finestFirst(const Hierarchy& hierarchy, const Level& level)
{
  std::vector<std::vector<DiamondId>> byLevel;
  for (std::size_t d = 0; d < level.active.size(); ++d)
  {
    if (level.active[d])
    {
      const std::size_t depth = hierarchy.cell(hierarchy.diamonds[d].firstCell).level;
      byLevel.resize(std::max(byLevel.size(), depth + 1));
      byLevel[depth].push_back(DiamondId(static_cast<Index>(d)));
    }
  }
  std::vector<DiamondId> result;
  for (auto depth = byLevel.rbegin(); depth != byLevel.rend(); ++depth)
  {
    result.insert(result.end(), depth->begin(), depth->end());
  }
  return result;
}

void raise(float* errors, const float* others, std::size_t count)
{
  std::transform(errors, errors + count, others, errors, [](float a, float b) { return std::max(a, b); });
}

/// |z(v) - z_T(v)| of the paper's equations 1 and 2, the largest over the cell's materials; by field the length.
void addChangeAtSplitVertex(const Hierarchy& hierarchy, CellId id, float* errors)
{
  const HierarchyCell& cell = hierarchy.cell(id);
  const VertexId middle = hierarchy.diamond(cell.diamond).vertex;
  std::vector<double> largest(hierarchy.fields.size(), 0.0);
  for (const MaterialId m : hierarchy.materialsOf(id))
  {
    const float* z = hierarchy.valuesOf(middle, m);
    const float* a = hierarchy.valuesOf(cell.corners[0], m);
    const float* b = hierarchy.valuesOf(cell.corners[cell.tag], m);
    int position = 1;
    for (std::size_t f = 0; f < hierarchy.fields.size(); ++f)
    {
      double squared = 0.0;
      for (int c = 0; c < hierarchy.fields[f].components; ++c, ++position)
      {
        const double change = z[position] - 0.5 * (static_cast<double>(a[position]) + b[position]);
        squared += std::isnan(change) ? 0.0 : change * change;
      }
      largest[f] = std::max(largest[f], std::sqrt(squared));
    }
  }
  for (std::size_t f = 0; f < largest.size(); ++f)
  {
    errors[1 + f] += static_cast<float>(largest[f]);
  }
}

ErrorTable cellErrors(const Hierarchy& hierarchy, const std::vector<float>& interfaceErrors)
{
  const std::size_t fields = hierarchy.fields.size();
  ErrorTable table{ 1 + fields, std::vector<float>(hierarchy.cells.size() * (1 + fields)) };
  for (std::size_t c = 0; c < hierarchy.cells.size(); ++c)
  {
    float* errors = table.of(static_cast<std::int32_t>(c));
    errors[0] = interfaceErrors[c];
    std::copy_n(hierarchy.fieldErrors.begin() + static_cast<std::ptrdiff_t>(c * fields), fields, errors + 1);
  }
  return table;
}

/// A cell's field errors become its children's plus the change at its split vertex (the paper's equation 1).
void accumulateInto(const Hierarchy& hierarchy, CellId id, ErrorTable& cells)
{
  const CellId child = hierarchy.cell(id).firstChild;
  float* errors = cells.of(id.value);
  const float* first = cells.of(child.value);
  const float* second = cells.of(child.value + 1);
  for (std::size_t c = 1; c < cells.criteria; ++c)
  {
    errors[c] = std::max(first[c], second[c]);
  }
  addChangeAtSplitVertex(hierarchy, id, errors);
}
}

Level selectSaturated(const Hierarchy& hierarchy, const Level& finest, const std::vector<float>& interfaceErrors,
  const ErrorBounds& bounds, bool accumulate)
{
  ErrorTable cells = cellErrors(hierarchy, interfaceErrors);
  const std::size_t criteria = cells.criteria;
  ErrorTable diamonds{ criteria, std::vector<float>(hierarchy.diamonds.size() * criteria, 0.0f) };
  std::vector<double> limits(criteria, bounds.interfaceError);
  std::copy(bounds.fieldErrors.begin(), bounds.fieldErrors.end(), limits.begin() + 1);
  Level result;
  result.active.resize(hierarchy.diamonds.size(), 0);
  result.cellCount = hierarchy.rootCount;
  for (const DiamondId id : finestFirst(hierarchy, finest))
  {
    float* errors = diamonds.of(id.value);
    Index count = 0;
    hierarchy.forCellsOf(id, [&](CellId c) {
      if (accumulate)
      {
        accumulateInto(hierarchy, c, cells);
      }
      raise(errors, cells.of(c.value), criteria);
      const CellId child = hierarchy.cell(c).firstChild;
      raise(errors, diamonds.of(hierarchy.cell(child).diamond.value), criteria);
      raise(errors, diamonds.of(hierarchy.cell(CellId(child.value + 1)).diamond.value), criteria);
      ++count;
    });
    const bool split = !std::equal(errors, errors + criteria, limits.begin(),
      [](float error, double limit) { return static_cast<double>(error) <= limit; });
    result.active[static_cast<std::size_t>(id.value)] = split ? 1 : 0;
    result.cellCount += split ? count : 0;
  }
  return result;
}
}
