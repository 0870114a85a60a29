#include "ExtractCases.h"

using namespace strata;
using namespace strata::test;

namespace
{
const Box unitBox{ Vector::Zero(), Vector::Ones() };

/// Three sectors of 120 degrees round a line along z.
FractionsOf sectors(int n)
{
  std::vector<Vector> directions;
  for (int m = 0; m < 3; ++m)
  {
    const double angle = 2.0 * M_PI * m / 3.0 + 0.2;
    directions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return smallestOf(directions, Vector(0.52, 0.49, 0.5), n);
}

const std::vector<Vector> tetrahedral = { Vector(1, 1, 1), Vector(1, -1, -1), Vector(-1, 1, -1), Vector(-1, -1, 1) };

/// A layer of material 1, `thickness` high, between two others.
FractionsOf sheet(const Vector& normal, double offset, double thickness)
{
  return [=](const Box& box) {
    const double below = fractionBelowPlane(box, normal, offset);
    const double above = 1.0 - fractionBelowPlane(box, normal, offset + thickness);
    return std::vector<double>{ below, 1.0 - below - above, above };
  };
}
}

TEST(Junctions, ThreeHalfPlanesMeetInALineWithoutGap)
{
  const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(8), 3, sectors(16)));
  expectSound(result.interfaces, 3, unitBox);
  EXPECT_EQ(result.interfaces.surfaces.size(), 3u);
  EXPECT_LT(largestCellError(result, 1.0 / 512.0), 1e-2);
  for (const VolumeReport& report : result.volumes)
  {
    EXPECT_NEAR(report.reconstructed, report.given, 1e-6);
  }
}

TEST(Junctions, FourMaterialsMeetInAPointWithoutGap)
{
  const ExtractedInterfaces result =
    extract(fractionSimulation(cubeGrid(8), 4, smallestOf(tetrahedral, Vector(0.51, 0.47, 0.53), 12)));
  expectSound(result.interfaces, 4, unitBox);
  EXPECT_EQ(result.interfaces.surfaces.size(), 6u);
  for (const VolumeReport& report : result.volumes)
  {
    EXPECT_NEAR(report.reconstructed, report.given, 1e-6);
  }
}

TEST(Junctions, RegionsFillTheBox)
{
  for (bool correct : { false, true })
  {
    const ExtractedInterfaces result =
      extract(fractionSimulation(cubeGrid(6), 4, smallestOf(tetrahedral, Vector(0.51, 0.47, 0.53), 12)), correct);
    double sum = 0.0;
    for (const VolumeReport& report : result.volumes)
    {
      sum += report.reconstructed;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(Junctions, ASheetThinnerThanACellIsKept)
{
  // 0.2 cells thick, inside one layer of cells.
  const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(8), 3, sheet(Vector::UnitZ(), 0.55, 0.025)));
  expectSound(result.interfaces, 3, unitBox);
  EXPECT_NEAR(result.volumes[1].reconstructed, 0.025, 1e-6);
  EXPECT_LT(largestCellError(result, 1.0 / 512.0), 1e-3);
  for (const Interfaces::Surface& surface : result.interfaces.surfaces)
  {
    EXPECT_FALSE(surface.positive.value == 0 && surface.negative.value == 2) << "the sheet has holes";
  }
}

TEST(Junctions, AnObliqueSheetThinnerThanACellKeepsItsVolume)
{
  const Vector normal = Vector(0.2, 0.3, 1.0).normalized();
  const Simulation simulation = fractionSimulation(cubeGrid(10), 3, sheet(normal, 0.6, 0.04));
  const ExtractedInterfaces result = extract(simulation);
  expectSound(result.interfaces, 3, unitBox);
  EXPECT_NEAR(result.volumes[1].reconstructed, result.volumes[1].given, 1e-3 * result.volumes[1].given);
}

TEST(Junctions, TheOrderOfMaterialsDoesNotMatter)
{
  const FractionsOf original = smallestOf(tetrahedral, Vector(0.51, 0.47, 0.53), 10);
  const std::vector<std::size_t> order = { 2, 0, 3, 1 };
  const auto permuted = [&](const Box& box) {
    const std::vector<double> fractions = original(box);
    std::vector<double> result;
    for (std::size_t m : order)
    {
      result.push_back(fractions[m]);
    }
    return result;
  };
  const ExtractedInterfaces a = extract(fractionSimulation(cubeGrid(6), 4, original));
  const ExtractedInterfaces b = extract(fractionSimulation(cubeGrid(6), 4, permuted));
  for (std::size_t m = 0; m < 4; ++m)
  {
    EXPECT_NEAR(b.volumes[m].reconstructed, a.volumes[order[m]].reconstructed, 1e-9);
  }
  EXPECT_EQ(a.interfaces.triangleCount(), b.interfaces.triangleCount());
}
