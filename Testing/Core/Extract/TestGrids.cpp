#include "ExtractCases.h"

#include "PolyhedralGrids.h"

#include <tbb/global_control.h>

using namespace strata;
using namespace strata::test;

namespace
{
const Box unitBox{ Vector::Zero(), Vector::Ones() };

void expectSame(const ExtractedInterfaces& a, const ExtractedInterfaces& b)
{
  EXPECT_EQ(a.interfaces.points, b.interfaces.points);
  ASSERT_EQ(a.interfaces.surfaces.size(), b.interfaces.surfaces.size());
  for (std::size_t s = 0; s < a.interfaces.surfaces.size(); ++s)
  {
    EXPECT_EQ(a.interfaces.surfaces[s].triangles, b.interfaces.surfaces[s].triangles);
  }
}

/// Puts a simulation on a grid or on the same cells as hexahedra.
void setGrid(Simulation& simulation, const RectilinearGrid& grid, bool unstructured)
{
  if (unstructured)
  {
    simulation.grid.emplace<UnstructuredGrid>(asHexahedra(grid));
  }
  else
  {
    simulation.grid.emplace<RectilinearGrid>(grid);
  }
}

/// Adds the material `outside`, which fills the hidden cells.
void addOutside(Simulation& simulation, const std::vector<std::uint8_t>& hidden)
{
  std::vector<std::vector<double>> values;
  for (const ValueArray& array : simulation.fractions)
  {
    std::vector<double> v;
    for (std::size_t c = 0; c < hidden.size(); ++c)
    {
      v.push_back(hidden[c] ? 0.0 : array(static_cast<Index>(c)));
    }
    values.push_back(v);
  }
  simulation.fractions.clear();
  for (const std::vector<double>& v : values)
  {
    simulation.fractions.push_back(ownedArray(v));
  }
  simulation.fractions.push_back(ownedArray(std::vector<double>(hidden.begin(), hidden.end())));
  simulation.materials.push_back({ "outside", false });
}
}

TEST(Grids, HexahedraGiveTheSameSurfacesAsTheRectilinearGrid)
{
  RectilinearGrid grid = cubeGrid(8);
  grid.coordinates[1] = { 0.0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 1.0 };
  Simulation simulation = fractionSimulation(grid, 2, insideOf(sphere({ 0.5, 0.4, 0.6 }, 0.45)));
  for (bool correct : { false, true })
  {
    simulation.grid.emplace<RectilinearGrid>(grid);
    const ExtractedInterfaces a = extract(simulation, correct);
    simulation.grid.emplace<UnstructuredGrid>(asHexahedra(grid));
    const ExtractedInterfaces b = extract(simulation, correct);
    expectSound(a.interfaces, 2, unitBox);
    if (!correct)
    {
      expectSame(a, b);
    }
    ASSERT_EQ(a.interfaces.points.size(), b.interfaces.points.size());
    EXPECT_NEAR(a.volumes[0].reconstructed, b.volumes[0].reconstructed, 1e-9);
  }
}

TEST(Grids, TheNumberOfThreadsDoesNotMatter)
{
  const Simulation simulation = fractionSimulation(cubeGrid(12), 2, insideOf(sphere({ 0.5, 0.4, 0.6 }, 0.3)));
  const ExtractedInterfaces a = extract(simulation);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  expectSame(a, extract(simulation));
}

TEST(Grids, SurfacesEndAtHiddenCellsWithTheOutside)
{
  RectilinearGrid grid = cubeGrid(8);
  grid.hidden.assign(512, 0);
  for (Index cell = 0; cell < 512; ++cell)
  {
    const Vector x = cellBox(grid, cell).center();
    grid.hidden[cell] = (x - Vector(0.5, 0.5, 0.5)).cwiseAbs().maxCoeff() < 0.25 ? 1 : 0;
  }
  Simulation simulation = fractionSimulation(grid, 2, insideOf(sphere({ 0.3, 0.3, 0.3 }, 0.4)));
  addOutside(simulation, grid.hidden);
  for (bool unstructured : { false, true })
  {
    setGrid(simulation, grid, unstructured);
    const ExtractedInterfaces result = extract(simulation);
    expectSound(result.interfaces, 3, unitBox);
    // A hole of 4^3 cells.
    EXPECT_NEAR(enclosedVolume(result.interfaces, MaterialId(2)), 0.125, 1e-12);
    surfaceBetween(result.interfaces, 0, 2);
    surfaceBetween(result.interfaces, 1, 2);
    EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6);
  }
}

TEST(Grids, AMeshThatIsNoBoxIsBoundedByTheOutside)
{
  // A sheared block: its sides lie in the box's sides at the top and bottom only.
  UnstructuredGrid mesh = asHexahedra(cubeGrid(6));
  for (Vector& point : mesh.points)
  {
    point[0] += 0.5 * point[2];
    point[1] += 0.25 * point[2];
  }
  Simulation simulation = fractionSimulation(cubeGrid(6), 2, insideOf(sphere({ 0.5, 0.5, 0.5 }, 0.6)));
  addOutside(simulation, std::vector<std::uint8_t>(216, 0));
  simulation.grid.emplace<UnstructuredGrid>(mesh);
  const ExtractedInterfaces result = extract(simulation);
  const Box box = bounds(simulation.grid);
  expectSound(result.interfaces, 3, box);
  EXPECT_NEAR(result.volumes[0].reconstructed + result.volumes[1].reconstructed, 1.0, 1e-12);
  EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6);
}

TEST(Grids, EveryShapeOfCellConforms)
{
  for (const UnstructuredGrid& mesh : { tetrahedra(6), wedges(6), pyramids(5), polyhedra(6) })
  {
    const Distance distance = sphere({ 0.45, 0.5, 0.55 }, 0.33);
    const Simulation simulation = sampledSimulation(mesh, distance);
    for (bool correct : { false, true })
    {
      const ExtractedInterfaces result = extract(simulation, correct);
      expectSound(result.interfaces, 2, unitBox);
      ASSERT_EQ(result.interfaces.surfaces.size(), 1u);
      EXPECT_NEAR(result.volumes[0].reconstructed + result.volumes[1].reconstructed, 1.0, 1e-12);
      EXPECT_NEAR(result.volumes[0].reconstructed, enclosedVolume(result.interfaces, MaterialId(0)), 1e-9);
      EXPECT_LT(meanDistance(result.interfaces, distance), 0.01);
    }
  }
}

TEST(Grids, MaterialIdsGiveTheFacesBetweenThem)
{
  const RectilinearGrid grid = cubeGrid(4);
  Simulation simulation;
  simulation.materials = namedMaterials(3);
  for (Index cell = 0; cell < 64; ++cell)
  {
    const Vector x = cellBox(grid, cell).center();
    simulation.materialIds.push_back((x - Vector(0.5, 0.5, 0.5)).cwiseAbs().maxCoeff() < 0.25 ? 1 : x[0] < 0.5 ? 0 : 2);
  }
  for (bool unstructured : { false, true })
  {
    setGrid(simulation, grid, unstructured);
    const ExtractedInterfaces result = extract(simulation);
    expectSound(result.interfaces, 3, unitBox);
    EXPECT_NEAR(enclosedVolume(result.interfaces, MaterialId(1)), 0.125, 1e-12);
    // Flat quadrangles become two triangles: half of the cube's 24 faces on either side, 12 faces beside it.
    EXPECT_EQ(surfaceBetween(result.interfaces, 0, 1).triangles.size(), 24u);
    EXPECT_EQ(surfaceBetween(result.interfaces, 1, 2).triangles.size(), 24u);
    EXPECT_EQ(surfaceBetween(result.interfaces, 0, 2).triangles.size(), 24u);
    EXPECT_DOUBLE_EQ(result.volumes[1].reconstructed, 0.125);
  }
}
