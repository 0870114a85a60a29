#pragma once

#include "Model/Lattice.h"

#include <array>
#include <vector>

namespace strata
{
/// A tetrahedron of the base mesh.
struct BaseCell
{
  std::array<LatticePoint, 4> corners;
  bool inverted; ///< its corners are negatively oriented
};

/// The six Kuhn tetrahedra of each of a lattice's cubes, cube by cube, x running fastest.
std::vector<BaseCell> baseCells(const Lattice& lattice);
}
