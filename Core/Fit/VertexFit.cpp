#include "Fit/VertexFit.h"

#include "Fit/Influence.h"
#include "Fit/RowErrors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata
{
namespace
{
/// How far a value may be moved.
struct Limits
{
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// Moves one number to where the objective is smallest near its start; a move that does not pay is not made.
void minimize(float& value, double reach, const Limits& limits, const Influence& influence)
{
  const double change =
    std::clamp(influence.bestChange(reach), std::min(limits.lowest, 0.0), std::max(limits.highest, 0.0));
  const float moved = value + static_cast<float>(change);
  if (influence.objective(static_cast<double>(moved) - static_cast<double>(value)) < influence.objective(0.0))
  {
    value = moved;
  }
}

/// One vertex with the rows of the cells round it.
class VertexFit
{
public:
  VertexFit(Hierarchy& values, const std::vector<CellId>& cells, const std::vector<CellRows>& rows,
    const ErrorBounds& bounds, VertexId vertex, const std::vector<std::size_t>& star) :
    values_(values),
    cells_(cells), rows_(rows), bounds_(bounds), vertex_(vertex), star_(star)
  {}

  void run()
  {
    for (const MaterialId m : values_.vertexMaterials[static_cast<std::size_t>(vertex_.value)])
    {
      gatherPlanes(m);
      move(m, 0, bounds_.interfaceError, distanceLimits(m));
      int position = 1;
      for (std::size_t f = 0; f < values_.fields.size(); ++f)
      {
        for (int c = 0; c < values_.fields[f].components; ++c)
        {
          gatherSamples(m, f, c);
          move(m, position++, bounds_.fieldErrors[f], {});
        }
      }
    }
  }

private:
  void move(MaterialId m, int position, double bound, const Limits& limits)
  {
    const double error = influence_.largest(0.0);
    if (error >= worthFitting && std::isfinite(error))
    {
      const auto first = static_cast<std::size_t>(values_.valuesOf(vertex_, m) - values_.values.data());
      minimize(values_.values[first + static_cast<std::size_t>(position)], 2.0 * error * bound, limits, influence_);
    }
  }

  double smallestDistance(MaterialSet materials) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const MaterialId m : materials)
    {
      smallest = std::min(smallest, static_cast<double>(*values_.valuesOf(vertex_, m)));
    }
    return smallest;
  }

  /// A material that a cell round the vertex does not hold must not become the nearest there: its region would
  /// reach into the cell, where no error is measured for it.
  Limits distanceLimits(MaterialId m) const
  {
    const double own = static_cast<double>(*values_.valuesOf(vertex_, m));
    const MaterialSet all = values_.vertexMaterials[static_cast<std::size_t>(vertex_.value)];
    Limits limits;
    for (const std::size_t c : star_)
    {
      const MaterialSet held = values_.materialsOf(cells_[c]);
      if (!held.contains(m))
      {
        limits.lowest = std::max(limits.lowest, smallestDistance(held) - own);
        continue;
      }
      const double absent = smallestDistance(all - held);
      if (smallestDistance(held - MaterialSet::of(m)) > absent)
      {
        limits.highest = std::min(limits.highest, absent - own);
      }
    }
    return limits;
  }

  std::size_t cornerIn(const HierarchyCell& cell) const
  {
    return static_cast<std::size_t>(
      std::find(cell.corners.begin(), cell.corners.end(), vertex_) - cell.corners.begin());
  }

  void gatherPlanes(MaterialId m)
  {
    influence_.clear();
    for (const std::size_t c : star_)
    {
      for (const CellRows::InterfaceVertices& group : rows_[c].interfaces)
      {
        if (group.positive == m || group.negative == m)
        {
          gatherPlane(values_.cell(cells_[c]), rows_[c], group, m);
        }
      }
    }
  }

  void gatherPlane(
    const HierarchyCell& cell, const CellRows& rows, const CellRows::InterfaceVertices& group, MaterialId m)
  {
    // A larger distance to the negative material raises the signed distance, one to the positive lowers it.
    const double sign = group.negative == m ? 1.0 : -1.0;
    const std::size_t own = cornerIn(cell);
    const SignedDistance distance = signedDistance(values_, cell, rows, group);
    influence_.beginGroup(bounds_.interfaceError, distance.gradient, sign * rows.gradients[own]);
    for (const CellRows::Weights& w : group.weights)
    {
      influence_.add(distance.at(w), -sign * w[own], 0.0);
    }
  }

  void gatherSamples(MaterialId m, std::size_t field, int component)
  {
    influence_.clear();
    for (const std::size_t c : star_)
    {
      for (const CellRows::Samples& samples : rows_[c].samples)
      {
        if (samples.material == m && samples.field == field)
        {
          gatherGroup(values_.cell(cells_[c]), samples, component);
        }
      }
    }
  }

  void gatherGroup(const HierarchyCell& cell, const CellRows::Samples& samples, int component)
  {
    const std::size_t own = cornerIn(cell);
    std::array<const float*, 4> corners;
    for (std::size_t k = 0; k < 4; ++k)
    {
      corners[k] = values_.valuesOf(cell.corners[k], samples.material) + samples.firstValue;
    }
    influence_.beginGroup(bounds_.fieldErrors[samples.field]);
    const double* native = samples.values.data();
    for (const CellRows::Weights& w : samples.weights)
    {
      double residual = 0.0;
      double others = 0.0;
      for (int c = 0; c < samples.components; ++c)
      {
        const double difference = *native++ - w[0] * static_cast<double>(corners[0][c]) -
                                  w[1] * static_cast<double>(corners[1][c]) -
                                  w[2] * static_cast<double>(corners[2][c]) - w[3] * static_cast<double>(corners[3][c]);
        residual = c == component ? difference : residual;
        others += c == component ? 0.0 : difference * difference;
      }
      if (!std::isnan(residual))
      {
        influence_.add(residual, w[own], others);
      }
    }
  }

  Hierarchy& values_;
  const std::vector<CellId>& cells_;
  const std::vector<CellRows>& rows_;
  const ErrorBounds& bounds_;
  VertexId vertex_;
  const std::vector<std::size_t>& star_;
  Influence influence_;
};

/// A vertex lies in a region whose distance is zero: all of a vertex's distances may shift together.
void groundDistances(Hierarchy& values, VertexId vertex)
{
  const MaterialSet materials = values.vertexMaterials[static_cast<std::size_t>(vertex.value)];
  float* first = values.values.data() + values.valueOffsets[static_cast<std::size_t>(vertex.value)];
  float smallest = std::numeric_limits<float>::infinity();
  for (int i = 0; i < materials.size(); ++i)
  {
    smallest = std::min(smallest, first[i * values.valuesPerMaterial]);
  }
  for (int i = 0; i < materials.size(); ++i)
  {
    first[i * values.valuesPerMaterial] -= smallest;
  }
}
}

void fitVertex(Hierarchy& values, const std::vector<CellId>& cells, const std::vector<CellRows>& rows,
  const ErrorBounds& bounds, VertexId vertex, const std::vector<std::size_t>& star)
{
  VertexFit(values, cells, rows, bounds, vertex, star).run();
  groundDistances(values, vertex);
}
}
