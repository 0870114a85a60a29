#include "Model/Lattice.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

namespace strata
{
namespace
{
constexpr std::int32_t unit = Lattice::cubeSize;

TEST(Lattice, CornersOfTheBoxAreHitExactly)
{
  Lattice lattice;
  lattice.box.lower = Vector(-0.1, 0.3, 1e6);
  lattice.box.upper = Vector(12.7, 0.7, 1e6 + 1.0);
  lattice.cubes = { 3, 1, 2 };
  EXPECT_EQ(lattice.box.lower, lattice.position({ { 0, 0, 0 } }));
  EXPECT_EQ(lattice.box.upper, lattice.position({ { 3 * unit, unit, 2 * unit } }));
}

TEST(Lattice, TheBaseCubesCenterHasNoParents)
{
  const Lattice lattice;
  EXPECT_EQ(0, lattice.parents({ { unit / 2, unit / 2, unit / 2 } }).count);
}

/// A plain bisection to a fixed depth: which diamonds' splits made each cell's newest vertex, found without any
/// arithmetic on diamond kinds.
struct Bisection
{
  struct Cell
  {
    std::array<LatticePoint, 4> corners;
    int tag = 3;
  };

  std::map<std::array<std::int32_t, 3>, std::map<std::array<std::int32_t, 3>, bool>> parentsOf;

  void descend(const Cell& cell, const LatticePoint* newest, int depth)
  {
    const std::size_t t = static_cast<std::size_t>(cell.tag);
    const LatticePoint z = midpoint(cell.corners[0], cell.corners[t]);
    auto& parents = parentsOf[z.at];
    if (newest)
    {
      parents[newest->at] = true;
    }
    if (depth == 0)
    {
      return;
    }
    Cell first = cell;
    first.corners[t] = z;
    Cell second = cell;
    std::copy(cell.corners.begin() + 1, cell.corners.begin() + 1 + cell.tag, second.corners.begin());
    second.corners[t] = z;
    first.tag = second.tag = cell.tag == 1 ? 3 : cell.tag - 1;
    descend(first, &z, depth - 1);
    descend(second, &z, depth - 1);
  }
};

TEST(Lattice, TheParentsOfADiamondAreTheOnesWhoseSplitsMakeItsCells)
{
  constexpr std::array<std::array<int, 3>, 6> paths = { { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 },
    { 2, 0, 1 }, { 2, 1, 0 } } };
  Lattice lattice;
  lattice.cubes = { 2, 1, 1 };
  Bisection bisection;
  for (int cube = 0; cube < 2; ++cube)
  {
    for (const auto& path : paths)
    {
      Bisection::Cell cell;
      LatticePoint at = { { cube * unit, 0, 0 } };
      cell.corners[0] = at;
      for (std::size_t i = 0; i < 3; ++i)
      {
        at[path[i]] += unit;
        cell.corners[i + 1] = at;
      }
      bisection.descend(cell, nullptr, 10);
    }
  }
  EXPECT_GT(bisection.parentsOf.size(), 1000u);
  for (const auto& [center, expected] : bisection.parentsOf)
  {
    std::map<std::array<std::int32_t, 3>, bool> found;
    for (const LatticePoint& parent : lattice.parents({ center }))
    {
      found[parent.at] = true;
    }
    EXPECT_EQ(expected, found) << center[0] << " " << center[1] << " " << center[2];
  }
}
}
}
