#include "Model/Lattice.h"

namespace strata
{
namespace
{
/// A diamond's kind follows from its centre: the coordinates that are odd multiples of the largest power of
/// two that divides all of them. Three: centre of a cube; two: of a face; one: of an edge (design 3.1).
struct DiamondKind
{
  std::int32_t scale = 0;
  std::array<bool, 3> odd = { false, false, false };
  int oddCount = 0;
};

DiamondKind kindOf(const LatticePoint& center)
{
  DiamondKind kind;
  const std::int32_t bits = center[0] | center[1] | center[2];
  kind.scale = bits & -bits;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    kind.odd[axis] = (center.at[axis] & kind.scale) != 0;
    kind.oddCount += kind.odd[axis] ? 1 : 0;
  }
  return kind;
}

/// The cube's split edge is the body diagonal that starts at its corner on the lattice twice as coarse; the
/// parents are the edge midpoints next to that corner.
LatticePoints parentsOfCube(const LatticePoint& center, const DiamondKind& kind)
{
  LatticePoint start = center;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool below = ((center[axis] - kind.scale) & (4 * kind.scale - 1)) == 0;
    start[axis] += below ? -kind.scale : kind.scale;
  }
  LatticePoints result;
  for (int axis = 0; axis < 3; ++axis)
  {
    LatticePoint parent = start;
    parent[axis] = 2 * center[axis] - start[axis];
    result.add(parent);
  }
  return result;
}
}

LatticePoint midpoint(const LatticePoint& a, const LatticePoint& b)
{
  LatticePoint result;
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = a[axis] + (b[axis] - a[axis]) / 2;
  }
  return result;
}

Vector Lattice::position(const LatticePoint& point) const
{
  Vector result;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double whole = static_cast<double>(cubes[static_cast<std::size_t>(axis)]) * cubeSize;
    const double t = point[axis] / whole;
    result[axis] = (1.0 - t) * box.lower[axis] + t * box.upper[axis];
  }
  return result;
}

bool Lattice::contains(const LatticePoint& point) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (point[axis] < 0 || point[axis] > cubes[static_cast<std::size_t>(axis)] * cubeSize)
    {
      return false;
    }
  }
  return true;
}

LatticePoints Lattice::parents(const LatticePoint& center) const
{
  const DiamondKind kind = kindOf(center);
  if (kind.oddCount == 3)
  {
    return 2 * kind.scale == cubeSize ? LatticePoints() : parentsOfCube(center, kind);
  }
  LatticePoints result;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (kind.odd[static_cast<std::size_t>(axis)])
    {
      continue;
    }
    for (const std::int32_t step : { -kind.scale, kind.scale })
    {
      LatticePoint parent = center;
      parent[axis] += step;
      if (contains(parent))
      {
        result.add(parent);
      }
    }
  }
  return result;
}
}
