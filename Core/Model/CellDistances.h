#pragma once

#include "Geometry/CutPoints.h"
#include "Model/Errors.h"
#include "Model/Representation.h"

#include <cmath>
#include <string>
#include <vector>

namespace strata
{
/// The vertices of a cell in their order.
inline std::array<std::int64_t, 4> verticesOfCell(const Representation& representation, Index cell)
{
  const std::int64_t* corners = representation.tetrahedra + 4 * cell;
  return { corners[0], corners[1], corners[2], corners[3] };
}

/// The distances of the materials of a cell at its corners: what the kernel cuts it by. A function's id is its
/// material. Throws InvalidInput for a cell without materials or with an infinite distance.
inline void distancesOfCell(const Representation& representation, Index cell, std::vector<CornerValues>& result)
{
  result.clear();
  const std::int64_t* corners = representation.tetrahedra + 4 * cell;
  for (const MaterialId m : materialsOfCell(representation, cell))
  {
    const float* distance = representation.distances[static_cast<std::size_t>(m.value)];
    result.push_back(
      { m.value, { distance[corners[0]], distance[corners[1]], distance[corners[2]], distance[corners[3]] } });
    for (double value : result.back().values)
    {
      if (std::isinf(value))
      {
        throw InvalidInput("a distance to material " + std::to_string(m.value) + " at a vertex of cell " +
                           std::to_string(cell) + " is infinite");
      }
    }
  }
  if (result.empty())
  {
    throw InvalidInput("cell " + std::to_string(cell) + " holds no material: no distance is known at all its vertices");
  }
}

/// The components of a field of one material at a point of a cut, interpolated; NaN where the material lacks it.
inline void interpolateField(const float* values, int components, const CutPoint& point, float* result)
{
  for (int c = 0; c < components; ++c)
  {
    result[c] = values ? static_cast<float>(point.interpolate(
                           [&](std::int64_t vertex) { return static_cast<double>(values[vertex * components + c]); }))
                       : std::nanf("");
  }
}

/// Writes the position of a point of a cut.
inline void interpolatePosition(const Representation& representation, const CutPoint& point, double* result)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = point.interpolate([&](std::int64_t vertex) { return representation.points[3 * vertex + axis]; });
  }
}
}
