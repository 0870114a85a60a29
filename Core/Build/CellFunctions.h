#pragma once

#include "Build/Tetrahedron.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// The values of one material at the corners of a cell; null where a vertex has none.
using MaterialCorners = std::array<const float*, 4>;

inline MaterialCorners materialCorners(const Hierarchy& hierarchy, const HierarchyCell& cell, MaterialId m)
{
  MaterialCorners result;
  for (std::size_t i = 0; i < 4; ++i)
  {
    result[i] = hierarchy.valuesOf(cell.corners[i], m);
  }
  return result;
}

/// The linear function that represents one of a material's values, at a position among them, within a cell.
inline LinearFunction representedFunction(const Barycentric& barycentric, const MaterialCorners& corners, int position)
{
  return barycentric.interpolant<float>(
    { corners[0][position], corners[1][position], corners[2][position], corners[3][position] });
}

inline std::array<Vector, 4> cornerPositions(const Hierarchy& hierarchy, CellId cell)
{
  const std::array<VertexId, 4>& corners = hierarchy.cell(cell).corners;
  return { hierarchy.position(corners[0]), hierarchy.position(corners[1]), hierarchy.position(corners[2]),
    hierarchy.position(corners[3]) };
}

/// The distance of a point to the plane on which a linear function is zero.
inline double distanceToPlane(const LinearFunction& function, const Vector& p)
{
  const double value = std::abs(function(p));
  return value > 0.0 ? value / function.gradient.norm() : 0.0;
}
}
