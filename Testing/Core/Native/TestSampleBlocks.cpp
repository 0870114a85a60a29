#include "SampledSimulations.h"

#include "Native/SampleBlocks.h"

#include <gtest/gtest.h>

#include <utility>

using namespace strata;
using namespace strata::test;

TEST(SampleBlocks, FindsTheNearestSampleOfAMaterial)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    Simulation simulation;
    const RectilinearGrid grid = boxGrid(9 + static_cast<int>(seed), 17, 8, 1.05);
    simulation.grid.emplace<RectilinearGrid>(grid);
    simulation.materials = { { "block", true }, { "rod", true } };
    for (Index cell = 0; cell < grid.cellCount(); ++cell)
    {
      simulation.materialIds.push_back(random() % 200 == 0 ? 1 : 0);
    }
    Progress progress;
    const SampleMaterials materials = findSampleMaterials(simulation, Association::Cells, 0.1, progress);
    const SampleLattice lattice = latticeOf(grid, Association::Cells);
    const SampleBlocks blocks(lattice, materials, progress);
    for (int query = 0; query < 20; ++query)
    {
      const Vector point = randomPoint(random);
      std::pair<double, Index> expected(10.0, -1);
      for (Index cell = 0; cell < grid.cellCount(); ++cell)
      {
        if (simulation.materialIds[static_cast<std::size_t>(cell)] == 1)
        {
          const double distance = (lattice.point(lattice.position(cell)) - point).squaredNorm();
          expected = std::min(expected, { distance, cell });
        }
      }
      EXPECT_EQ(blocks.nearest(lattice, materials, rod, point), expected.second);
    }
    EXPECT_EQ(blocks.nearest(lattice, materials, MaterialId(5), Vector::Zero()), -1);
  }
}
