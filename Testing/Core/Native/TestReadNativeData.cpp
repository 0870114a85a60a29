#include "SampledSimulations.h"
#include "UnstructuredGrids.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

using namespace strata;
using namespace strata::test;

namespace
{
const MaterialId gas(2);

/// A row of cells with three materials, the last without fields, and one field in all of them.
Simulation rowOfCells(const std::vector<std::array<double, 3>>& fractions)
{
  Simulation simulation;
  simulation.grid = boxGrid(static_cast<int>(fractions.size()), 1, 1);
  simulation.materials = { { "block", true }, { "rod", true }, { "gas", false } };
  for (std::size_t m = 0; m < 3; ++m)
  {
    std::vector<double> values;
    for (const auto& cell : fractions)
    {
      values.push_back(cell[m]);
    }
    simulation.fractions.push_back(ownedArray(values));
  }
  SimulationField field;
  field.name = "density";
  const std::vector<double> ones(fractions.size(), 1.0);
  field.values = { ownedArray(ones), ownedArray(ones), ValueArray() };
  simulation.fields = { field };
  return simulation;
}

MaterialSet setOf(std::initializer_list<MaterialId> materials)
{
  MaterialSet result;
  for (const MaterialId m : materials)
  {
    result.insert(m);
  }
  return result;
}
}

TEST(ReadNativeData, CountsASampleFromTheMinimumVolumeFractionOn)
{
  const Simulation simulation = rowOfCells({ { 0.5, 0.1, 0.4 }, { 0.91, 0.09, 0.0 }, { 0.25, 0.0, 0.75 } });
  const auto data = read(simulation);
  EXPECT_EQ(materialsOf(*data, 0), setOf({ block, rod }));
  EXPECT_EQ(materialsOf(*data, 1), setOf({ block }));
  EXPECT_EQ(materialsOf(*data, 2), setOf({ block }));
  const auto strict = read(simulation, 0.3);
  EXPECT_EQ(materialsOf(*strict, 0), setOf({ block }));
  EXPECT_EQ(materialsOf(*strict, 2), setOf({}));
}

TEST(ReadNativeData, CountsASampleForTheLargestFractionHoweverSmall)
{
  const auto data = read(rowOfCells({ { 0.3, 0.4, 0.3 }, { 0.4, 0.4, 0.2 }, { 0.2, 0.2, 0.6 } }), 0.5);
  EXPECT_EQ(materialsOf(*data, 0), setOf({ rod }));
  EXPECT_EQ(materialsOf(*data, 1), setOf({ block })) << "the lower index wins a tie";
  EXPECT_EQ(materialsOf(*data, 2), setOf({})) << "the largest fraction is of a material without fields";
}

TEST(ReadNativeData, NeverCountsAnAbsentMaterial)
{
  const auto data = read(rowOfCells({ { 1.0, 0.0, 0.0 } }), 0.0);
  EXPECT_EQ(materialsOf(*data, 0), setOf({ block }));
}

TEST(ReadNativeData, CountsMaterialIds)
{
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
  simulation.fractions.clear();
  simulation.materialIds = { 1, 0, 2 };
  const auto data = read(simulation);
  EXPECT_EQ(materialsOf(*data, 0), setOf({ rod }));
  EXPECT_EQ(materialsOf(*data, 1), setOf({ block }));
  EXPECT_EQ(materialsOf(*data, 2), setOf({}));
  simulation.materialIds = { 1, 7, 2 };
  EXPECT_EQ(messageOf(simulation), "material id 7 of cell 1: there are 3 materials");
}

TEST(ReadNativeData, LeavesOutHiddenCells)
{
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
  std::get<RectilinearGrid>(simulation.grid).hidden = { 0, 1 };
  // What a hidden cell holds is never read.
  simulation.fields[0].values[1] = ownedArray({ 1.0, std::numeric_limits<double>::quiet_NaN() });
  const auto data = read(simulation);
  EXPECT_EQ(materialsOf(*data, 0), setOf({ block }));
  EXPECT_EQ(materialsOf(*data, 1), setOf({}));
}

TEST(ReadNativeData, CountsAPointForTheMeanFractionOfTheVisibleCellsRoundIt)
{
  // Points 0..3 along x lie at the ends of the cells; their fractions of the rod are 0, 0.08, 0.58 and 1.
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0.84, 0.16, 0 }, { 0, 1, 0 } });
  SimulationField field;
  field.name = "speed";
  field.association = Association::Points;
  const std::vector<double> ones(16, 1.0);
  field.values = { ownedArray(ones), ownedArray(ones), ValueArray() };
  simulation.fields = { field };
  for (const bool unstructuredGrid : { false, true })
  {
    Simulation tested = simulation;
    if (unstructuredGrid)
    {
      tested.grid = unstructured(std::get<RectilinearGrid>(simulation.grid), CellShape::Hexahedron);
    }
    const auto data = read(tested);
    ASSERT_EQ(data->sampleCount(), 16u);
    EXPECT_EQ(materialsOf(*data, 0), setOf({ block }));
    EXPECT_EQ(materialsOf(*data, 1), setOf({ block }));
    EXPECT_EQ(materialsOf(*data, 6), setOf({ block, rod }));
    EXPECT_EQ(materialsOf(*data, 3), setOf({ rod }));
    std::visit([](auto& grid) { grid.hidden = { 0, 1, 1 }; }, tested.grid);
    const auto hidden = read(tested);
    EXPECT_EQ(materialsOf(*hidden, 1), setOf({ block }));
    EXPECT_EQ(materialsOf(*hidden, 2), setOf({})) << "all cells round it are hidden";
  }
}

TEST(ReadNativeData, CountsAPointForAllIdsRoundIt)
{
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
  simulation.fractions.clear();
  simulation.materialIds = { 0, 1 };
  SimulationField field;
  field.association = Association::Points;
  const std::vector<double> ones(12, 1.0);
  field.values = { ownedArray(ones), ownedArray(ones), ValueArray() };
  simulation.fields = { field };
  const auto data = read(simulation);
  EXPECT_EQ(materialsOf(*data, 0), setOf({ block }));
  EXPECT_EQ(materialsOf(*data, 1), setOf({ block, rod }));
  EXPECT_EQ(materialsOf(*data, 2), setOf({ rod }));
}

TEST(ReadNativeData, CountsACellForTheMeanFractionAtItsCorners)
{
  // The block's fraction is 1 at x = 0, 0.05 at x = 1/2, 0 at x = 1: 0.525 and 0.025 in the cells.
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 1, 0, 0 } });
  simulation.fractionAssociation = Association::Points;
  std::array<std::vector<double>, 3> fractions;
  for (int i = 0; i < 4; ++i)
  {
    for (const double x : { 1.0, 0.05, 0.0 })
    {
      fractions[0].push_back(x);
      fractions[1].push_back(1.0 - x);
      fractions[2].push_back(0.0);
    }
  }
  simulation.fractions = { ownedArray(fractions[0]), ownedArray(fractions[1]), ownedArray(fractions[2]) };
  for (const bool unstructuredGrid : { false, true })
  {
    Simulation tested = simulation;
    if (unstructuredGrid)
    {
      tested.grid = unstructured(std::get<RectilinearGrid>(simulation.grid), CellShape::Hexahedron);
    }
    const auto data = read(tested);
    EXPECT_EQ(materialsOf(*data, 0), setOf({ block, rod }));
    EXPECT_EQ(materialsOf(*data, 1), setOf({ rod }));
  }
}

TEST(ReadNativeData, NamesTheFieldMaterialAndCellOfAValueThatIsNotFinite)
{
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0.5, 0.5, 0 }, { 0, 1, 0 } });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  simulation.fields[0].values[1] = ownedArray({ nan, 2.0, nan });
  EXPECT_EQ(messageOf(simulation), "field \"density\" of material \"rod\" is nan in cell 2");
  simulation.fields[0].values[1] = ownedArray({ nan, -std::numeric_limits<double>::infinity(), nan });
  EXPECT_EQ(messageOf(simulation), "field \"density\" of material \"rod\" is -inf in cell 1");
  simulation.fields[0].values[1] = ownedArray({ nan, 2.0, 3.0 });
  EXPECT_EQ(messageOf(simulation), "") << "where the rod is absent its value is never read";
}

TEST(ReadNativeData, HasNoValueWhereAMaterialLacksAField)
{
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
  SimulationField temperature = simulation.fields[0];
  temperature.name = "temperature";
  temperature.values[1] = ValueArray();
  simulation.fields.push_back(temperature);
  const auto data = read(simulation);
  EXPECT_EQ(materialsOf(*data, 1), setOf({ rod }));
  EXPECT_TRUE(std::isnan(sampleValue(*data, FieldId(1), rod, 1)));
  for (const GhostMethod method : { GhostMethod::DataThenLinear, GhostMethod::Linear, GhostMethod::Constant })
  {
    std::array<double, 2> values{};
    data->evaluate(rod, Vector(0.2, 0.5, 0.5), false, Vector(0.5, 0.5, 0.5), method, values.data());
    EXPECT_EQ(values[0], 1.0);
    EXPECT_TRUE(std::isnan(values[1]));
  }
}

TEST(ReadNativeData, PutsCellSamplesBeforePointSamples)
{
  const RectilinearGrid grid = boxGrid(3, 4, 5);
  std::mt19937 random(2);
  const Function density = randomLinear(random);
  const Function speed = randomLinear(random);
  Simulation simulation = twoMaterials(
    grid, [](const Vector&) { return 1.0; }, density);
  simulation.fields.insert(simulation.fields.begin(),
    scalarField("speed", speed, 2, Association::Points, samplePoints(grid, Association::Points)));
  for (const bool unstructuredGrid : { false, true })
  {
    if (unstructuredGrid)
    {
      simulation.grid = unstructured(grid, CellShape::Hexahedron);
    }
    const auto data = read(simulation);
    ASSERT_EQ(data->sampleCount(), 60u + 120u);
    EXPECT_NEAR((positionOf(*data, 0) - Vector(1.0 / 6, 1.0 / 8, 1.0 / 10)).norm(), 0.0, 1e-14);
    EXPECT_EQ(positionOf(*data, 60), Vector(0, 0, 0));
    EXPECT_TRUE(std::isnan(sampleValue(*data, FieldId(0), block, 59)));
    EXPECT_TRUE(std::isnan(sampleValue(*data, FieldId(1), block, 60)));
    EXPECT_EQ(sampleValue(*data, FieldId(0), block, 61), speed(block, Vector(1.0 / 3, 0, 0)));
    EXPECT_EQ(materialsOf(*data, 60), setOf({ block }));
    for (int i = 0; i < 20; ++i)
    {
      const Vector point = randomPoint(random);
      std::array<double, 2> values{};
      data->evaluate(block, point, true, point, GhostMethod::DataThenLinear, values.data());
      EXPECT_NEAR(values[0], speed(block, point), 1e-10);
      EXPECT_NEAR(values[1], density(block, point), 1e-10);
    }
  }
}

TEST(ReadNativeData, TellsTheRangeOfTheLengthOfAVector)
{
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
  simulation.fields[0].components = 2;
  simulation.fields[0].values = { ownedArray({ 3, 4, 100, 100 }, 2), ownedArray({ 100, 100, 0, -1 }, 2), {} };
  EXPECT_DOUBLE_EQ(read(simulation)->range(FieldId(0)), 4.0);
  simulation.fields[0].components = 1;
  simulation.fields[0].values = { ownedArray({ -3, 50 }), ownedArray({ 50, 2 }), {} };
  EXPECT_DOUBLE_EQ(read(simulation)->range(FieldId(0)), 5.0);
}

TEST(ReadNativeData, RefusesArraysThatDontFitTheGrid)
{
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
  simulation.fields[0].values[0] = ownedArray({ 1, 2, 3 });
  EXPECT_EQ(messageOf(simulation), "field \"density\" of material \"block\" has 3 values; the grid has 2 cells");
  simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
  simulation.fractions.pop_back();
  EXPECT_EQ(messageOf(simulation), "arrays of volume fractions: 2 instead of 3");
  simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
  std::get<RectilinearGrid>(simulation.grid).coordinates[0] = { 0.0, 1.0, 0.5 };
  EXPECT_EQ(messageOf(simulation), "coordinate 2 of axis 0 is 0.500000 after 1.000000");
  simulation.grid = UnstructuredGrid();
  EXPECT_EQ(messageOf(simulation), "the grid has no cells");
}

TEST(ReadNativeData, ReadsASimulationWithoutFields)
{
  Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
  simulation.fields.clear();
  const auto data = read(simulation);
  EXPECT_EQ(data->componentCount(), 0);
  EXPECT_EQ(materialsOf(*data, 1), setOf({ rod }));
}

TEST(ReadNativeData, OutlivesTheSimulation)
{
  std::unique_ptr<NativeData> data;
  {
    const Simulation simulation = rowOfCells({ { 1, 0, 0 }, { 0, 1, 0 } });
    data = read(simulation);
  }
  EXPECT_EQ(valueAt(*data, block, Vector(0.25, 0.5, 0.5)), 1.0);
}

TEST(ReadNativeData, StopsWhenAsked)
{
  Progress progress([](const std::string&, double) { return false; });
  const Simulation simulation = rowOfCells({ { 1, 0, 0 } });
  EXPECT_THROW(readNativeData(simulation, {}, progress), Cancelled);
}

TEST(ReadNativeData, GivesTheSameBytesWithAnyNumberOfThreads)
{
  const Function field = [](MaterialId m, const Vector& p) {
    return std::sin(9.0 * p.x() + m.value) * std::cos(5.0 * p.y()) + p.z();
  };
  // More than one chunk of samples.
  const RectilinearGrid grid = boxGrid(48, 48, 48);
  Simulation simulation = twoMaterials(
    grid, [](const Vector& p) { return std::clamp(20.0 * (p.norm() - 0.7), 0.0, 1.0); }, field);
  for (const bool unstructuredGrid : { false, true })
  {
    if (unstructuredGrid)
    {
      simulation.grid = unstructured(grid, CellShape::Hexahedron);
    }
    std::array<std::vector<double>, 2> values;
    for (std::size_t run = 0; run < 2; ++run)
    {
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, run == 0 ? 1 : 4);
      const auto data = read(simulation);
      std::mt19937 random(1);
      for (int i = 0; i < 500; ++i)
      {
        const Vector point = randomPoint(random);
        const Vector closest = 0.7 * point.normalized();
        const bool inBlock = point.norm() > 0.7;
        values[run].push_back(valueAt(*data, block, point, inBlock, closest));
        values[run].push_back(valueAt(*data, rod, point, !inBlock, closest));
      }
      values[run].push_back(data->range(FieldId(0)));
    }
    EXPECT_EQ(values[0], values[1]);
  }
}
