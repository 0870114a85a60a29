#pragma once

#include "Geometry/Vector.h"
#include "Model/Ids.h"

#include <tuple>
#include <vector>

namespace strata
{
/// Two materials, the lower one first.
struct UnorderedPair
{
  MaterialId lower;
  MaterialId upper;

  static UnorderedPair of(MaterialId a, MaterialId b) { return a < b ? UnorderedPair{ a, b } : UnorderedPair{ b, a }; }
  friend bool operator<(const UnorderedPair& a, const UnorderedPair& b)
  {
    return std::tie(a.lower, a.upper) < std::tie(b.lower, b.upper);
  }
};

/// A convex, planar polygon of the interface between two materials.
struct InterfacePiece
{
  UnorderedPair materials;
  std::vector<Vector> corners;
};
}
