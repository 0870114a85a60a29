#include "Extract/Extract.h"

#include "Support/FractionsOfBox.h"
#include "Support/FractionsOnGrids.h"
#include "SurfaceChecks.h"

#include <gtest/gtest.h>

#include <random>

using namespace strata;
using namespace strata::test;

namespace
{
ExtractedInterfaces extract(const Simulation& simulation, bool correct)
{
  Progress progress;
  ExtractOptions options;
  options.volumeCorrection = correct;
  return extractInterfaces(simulation, options, progress);
}

FractionsOf sphereFractions(const Vector& center, double radius)
{
  return [=](const Box& box) {
    const double inside = fractionInside(
      box, [&](const Vector& x) { return (x - center).norm() - radius; }, 4);
    return std::vector<double>{ inside, 1.0 - inside };
  };
}
}

TEST(Extract, ASphereIsClosedAndItsVolumeIsNearlyRight)
{
  const RectilinearGrid grid = cubeGrid(16);
  const Simulation simulation = fractionSimulation(grid, 2, sphereFractions({ 0.5, 0.51, 0.49 }, 0.3));
  const ExtractedInterfaces result = extract(simulation, false);
  expectSound(result.interfaces, 2, bounds(simulation.grid));
  const double exact = 4.0 / 3.0 * M_PI * 0.027;
  EXPECT_NEAR(result.volumes[0].given, exact, 1e-5);
  EXPECT_NEAR(result.volumes[0].reconstructed, enclosedVolume(result.interfaces, MaterialId(0)), 1e-12);
  EXPECT_NEAR(result.volumes[0].reconstructed, exact, 0.05 * exact);
}

TEST(Extract, HexahedraGiveTheSameSurfacesAsTheRectilinearGrid)
{
  const RectilinearGrid grid = cubeGrid(8);
  Simulation simulation = fractionSimulation(grid, 2, sphereFractions({ 0.5, 0.4, 0.6 }, 0.55));
  const ExtractedInterfaces a = extract(simulation, false);
  simulation.grid = asHexahedra(grid);
  const ExtractedInterfaces b = extract(simulation, false);
  expectSound(a.interfaces, 2, bounds(simulation.grid));
  EXPECT_EQ(a.interfaces.points, b.interfaces.points);
  ASSERT_EQ(a.interfaces.surfaces.size(), b.interfaces.surfaces.size());
  EXPECT_EQ(a.interfaces.surfaces[0].triangles, b.interfaces.surfaces[0].triangles);
}
