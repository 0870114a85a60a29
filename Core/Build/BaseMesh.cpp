#include "Build/BaseMesh.h"

namespace strata
{
namespace
{
/// The monotone paths from (0,0,0) to (1,1,1), as the axes along which they step: each is a tetrahedron's corners.
constexpr std::array<std::array<int, 3>, 6> kuhnPaths = { { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 },
  { 2, 0, 1 }, { 2, 1, 0 } } };

BaseCell cellAlong(const std::array<int, 3>& path, LatticePoint at)
{
  BaseCell cell;
  cell.corners[0] = at;
  for (std::size_t step = 0; step < 3; ++step)
  {
    at[path[step]] += Lattice::cubeSize;
    cell.corners[step + 1] = at;
  }
  // Three steps turn as their order does.
  cell.inverted = (path[0] + 1) % 3 != path[1];
  return cell;
}
}

std::vector<BaseCell> baseCells(const Lattice& lattice)
{
  std::vector<BaseCell> result;
  for (int k = 0; k < lattice.cubes[2]; ++k)
  {
    for (int j = 0; j < lattice.cubes[1]; ++j)
    {
      for (int i = 0; i < lattice.cubes[0]; ++i)
      {
        for (const std::array<int, 3>& path : kuhnPaths)
        {
          result.push_back(
            cellAlong(path, { { i * Lattice::cubeSize, j * Lattice::cubeSize, k * Lattice::cubeSize } }));
        }
      }
    }
  }
  return result;
}
}
