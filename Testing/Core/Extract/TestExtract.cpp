#include "ExtractCases.h"

#include <random>

using namespace strata;
using namespace strata::test;

namespace
{
Distance plane(const Vector& normal, const Vector& point)
{
  return [=](const Vector& x) { return normal.dot(x - point); };
}

FractionsOf belowPlane(const Vector& normal, const Vector& point)
{
  return [=](const Box& box) {
    const double below = fractionBelowPlane(box, normal, normal.dot(point));
    return std::vector<double>{ below, 1.0 - below };
  };
}
}

TEST(Extract, RandomPlanesKeepTheirPlaceAndVolume)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normals;
  std::uniform_real_distribution<double> offsets(0.3, 0.7);
  const int n = 8;
  for (int seed = 0; seed < 20; ++seed)
  {
    const Vector normal = Vector(normals(random), normals(random), normals(random)).normalized();
    const Vector point(offsets(random), offsets(random), offsets(random));
    const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(n), 2, belowPlane(normal, point)));
    expectSound(result.interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
    EXPECT_LT(largestCellError(result, 1.0 / (n * n * n)), 1e-3) << "seed " << seed;
    EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6);
    EXPECT_LT(meanDistance(result.interfaces, plane(normal, point)), 0.01 / n) << "seed " << seed;
  }
}

TEST(Extract, PlanesInAFinerGridKeepTheVolumeOfEveryCell)
{
  std::mt19937 random(8);
  std::normal_distribution<double> normals;
  const int n = 16;
  for (int seed = 0; seed < 5; ++seed)
  {
    const Vector normal = Vector(normals(random), normals(random), normals(random)).normalized();
    const Vector point = Vector::Constant(0.5);
    const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(n), 2, belowPlane(normal, point)));
    EXPECT_LT(largestCellError(result, 1.0 / (n * n * n)), 1e-3) << "seed " << seed;
    EXPECT_NEAR(result.volumes[0].reconstructed / result.volumes[0].given, 1.0, 1e-6) << "seed " << seed;
    EXPECT_LT(meanDistance(result.interfaces, plane(normal, point)), 0.005 / n) << "seed " << seed;
  }
}

TEST(Extract, SharedCellsBetweenPureOnesAreRightWithinAThousandth)
{
  // A layer of mixed cells whose fractions no smooth border has: every cell asks for its own height.
  const int n = 8;
  const auto fractions = [](const Box& box) {
    const auto layer = static_cast<int>(std::floor(box.lower[2] * n + 0.5));
    const auto column = static_cast<int>(std::floor((3.0 * box.lower[0] + 5.0 * box.lower[1]) * n + 0.5));
    const double first = layer < 4 ? 1.0 : layer > 4 ? 0.0 : 0.35 + 0.06 * (column % 6);
    return std::vector<double>{ first, 1.0 - first };
  };
  const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(n), 2, fractions));
  expectSound(result.interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
  EXPECT_LT(largestCellError(result, 1.0 / (n * n * n)), 1e-3);
  EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-9);
}

TEST(Extract, TotalsHoldThoughDustIsDropped)
{
  // Four cells in a corner hold 5e-6 of the volume, too little in each for a region of its own.
  const int n = 16;
  const FractionsOf ball = insideOf(sphere(Vector(0.53, 0.52, 0.51), 0.3));
  const auto fractions = [&](const Box& box) {
    const bool dusty = box.lower.maxCoeff() < 1.5 / n && box.lower[2] < 0.5 / n;
    return dusty ? std::vector<double>{ 0.005, 0.995 } : ball(box);
  };
  const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(n), 2, fractions));
  EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-8);
}

TEST(Extract, SmearedFractionsGiveASmoothSphereOfTheSameVolume)
{
  // A profile of about four cells across the sphere, as solvers leave it.
  const int n = 24;
  const Distance ball = sphere(Vector(0.53, 0.48, 0.51), 0.3);
  const auto smeared = [&](const Box& box) {
    const double inside = 0.5 * (1.0 - std::tanh(ball(box.center()) * n));
    return std::vector<double>{ inside, 1.0 - inside };
  };
  const Simulation simulation = fractionSimulation(cubeGrid(n), 2, smeared);
  const ExtractedInterfaces result = extract(simulation);
  expectSound(result.interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
  EXPECT_EQ(result.smearing, 1.0);
  EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6);
  // The profile holds (1 + (pi w / 2 r)^2) times the sphere's volume, w being its width: a radius of 0.3047.
  EXPECT_LT(meanDistance(result.interfaces, sphere(Vector(0.53, 0.48, 0.51), 0.3047)), 0.1 / n);
  const ExtractedInterfaces each = extract(simulation, true, false);
  EXPECT_EQ(each.smearing, 0.0);
  EXPECT_LT(each.volumes[0].meanError, 0.1 * result.volumes[0].meanError);
  EXPECT_GT(each.interfaces.points.size(), 2 * result.interfaces.points.size());
}

TEST(Extract, SmearedFractionsBesidePureCellsKeepTheTotal)
{
  // A layer over cells that hold nothing of it, then cells half full: the border moves into the pure ones.
  const int n = 16;
  const auto smeared = [&](const Box& box) {
    const double x = box.center()[0] * n;
    const double y = box.center()[1] * n;
    const double height = 7.3 + 0.5 * std::sin(0.7 * y);
    const double inside = x < height ? 1.0 : std::max(0.0, 0.45 - 0.1 * (x - height));
    return std::vector<double>{ inside, 1.0 - inside };
  };
  const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(n), 2, smeared));
  expectSound(result.interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
  EXPECT_GT(result.smearing, 0.0);
  EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-8);
}

TEST(Extract, SharpFractionsAreTakenAtTheirWord)
{
  // A ball and, off it, a sheet that fills no cell.
  const int n = 16;
  const FractionsOf ball = insideOf(sphere(Vector(0.53, 0.48, 0.35), 0.25));
  const auto fractions = [&](const Box& box) {
    const bool sheet = box.lower[2] > 0.8 && box.lower[2] < 0.8 + 1.0 / n;
    return sheet ? std::vector<double>{ 0.4, 0.6 } : ball(box);
  };
  const Simulation simulation = fractionSimulation(cubeGrid(n), 2, fractions);
  const ExtractedInterfaces gathered = extract(simulation);
  const ExtractedInterfaces each = extract(simulation, true, false);
  EXPECT_EQ(gathered.smearing, 0.0);
  EXPECT_EQ(gathered.interfaces.points, each.interfaces.points);
  EXPECT_LT(largestCellError(gathered, 1.0 / (n * n * n)), 1e-3);
}

TEST(Extract, APlaneAlongTheGridIsExact)
{
  const Simulation simulation = fractionSimulation(cubeGrid(5), 2, belowPlane(Vector::UnitZ(), Vector(0.0, 0.0, 0.47)));
  for (bool correct : { false, true })
  {
    for (const Vector& point : extract(simulation, correct).interfaces.points)
    {
      EXPECT_NEAR(point[2], 0.47, 1e-9);
    }
  }
}

TEST(Extract, NormalsPointIntoTheLowerMaterial)
{
  const ExtractedInterfaces result =
    extract(fractionSimulation(cubeGrid(4), 2, belowPlane(Vector::UnitX(), Vector(0.4, 0.0, 0.0))));
  const Interfaces::Surface& surface = surfaceBetween(result.interfaces, 0, 1);
  for (const auto& t : surface.triangles)
  {
    const std::vector<Vector>& p = result.interfaces.points;
    EXPECT_LT((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]])[0], 0.0);
  }
}

TEST(Extract, ASphereConvergesWithSecondOrder)
{
  const Distance distance = sphere({ 0.5, 0.51, 0.49 }, 0.3);
  std::vector<double> errors;
  for (int n : { 12, 24, 48 })
  {
    const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(n), 2, insideOf(distance)));
    expectSound(result.interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
    EXPECT_LT(largestCellError(result, 1.0 / (n * n * n)), 1e-3);
    EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6 * result.volumes[0].given);
    EXPECT_NEAR(result.volumes[0].reconstructed, enclosedVolume(result.interfaces, MaterialId(0)), 1e-12);
    errors.push_back(meanDistance(result.interfaces, distance));
  }
  EXPECT_GT(std::log2(errors[0] / errors[2]) / 2.0, 1.8);
}

TEST(Extract, ATorusIsClosedWithOneHandle)
{
  const auto distance = [](const Vector& x) {
    const Vector d = x - Vector(0.5, 0.5, 0.5);
    return std::hypot(std::hypot(d[0], d[1]) - 0.27, d[2]) - 0.12;
  };
  const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(20), 2, insideOf(distance)));
  expectSound(result.interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
  EXPECT_NEAR(result.volumes[0].reconstructed, 2.0 * M_PI * M_PI * 0.27 * 0.12 * 0.12, 1e-3 * 0.077);
  const auto points = static_cast<Index>(result.interfaces.points.size());
  EXPECT_EQ(points - result.interfaces.triangleCount() / 2, 0) << "Euler characteristic";
}

TEST(Extract, ConcentricShellsStayApart)
{
  const Vector center(0.48, 0.5, 0.52);
  const Simulation simulation =
    fractionSimulation(cubeGrid(20), 3, nested({ sphere(center, 0.22), sphere(center, 0.35) }));
  const ExtractedInterfaces result = extract(simulation);
  expectSound(result.interfaces, 3, Box{ Vector::Zero(), Vector::Ones() });
  ASSERT_EQ(result.interfaces.surfaces.size(), 2u);
  surfaceBetween(result.interfaces, 0, 1);
  surfaceBetween(result.interfaces, 1, 2);
  EXPECT_LT(largestCellError(result, 1.0 / 8000.0), 1e-3);
}

TEST(Extract, OneCellOfOneMaterialGivesNothing)
{
  const ExtractedInterfaces result =
    extract(fractionSimulation(cubeGrid(1), 1, [](const Box&) { return std::vector<double>{ 1.0 }; }));
  EXPECT_TRUE(result.interfaces.surfaces.empty());
  EXPECT_TRUE(result.interfaces.points.empty());
  EXPECT_DOUBLE_EQ(result.volumes[0].given, 1.0);
  EXPECT_DOUBLE_EQ(result.volumes[0].reconstructed, 1.0);
}

TEST(Extract, OneMixedCellIsCutByItsFraction)
{
  const ExtractedInterfaces result = extract(fractionSimulation(cubeGrid(1), 2, [](const Box&) {
    return std::vector<double>{ 0.3, 0.7 };
  }));
  expectSound(result.interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
  EXPECT_NEAR(result.volumes[0].reconstructed, 0.3, 1e-3);
}

TEST(Extract, EqualFractionsEverywhereAreSound)
{
  const Simulation ties = fractionSimulation(cubeGrid(3), 2, [](const Box&) {
    return std::vector<double>{ 0.5, 0.5 };
  });
  expectSound(extract(ties, false).interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
  expectSound(extract(ties, true).interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
}

TEST(Extract, ACheckerboardIsSound)
{
  const Simulation board = fractionSimulation(cubeGrid(4), 2, [](const Box& box) {
    const Vector cell = box.lower * 4.0;
    const bool black = std::lround(cell.sum()) % 2 == 0;
    return std::vector<double>{ black ? 1.0 : 0.0, black ? 0.0 : 1.0 };
  });
  expectSound(extract(board, false).interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
  expectSound(extract(board, true).interfaces, 2, Box{ Vector::Zero(), Vector::Ones() });
}

TEST(Extract, FractionsAtPointsAreContouredWhereTheyAreEqual)
{
  const RectilinearGrid grid = cubeGrid(4);
  Simulation simulation;
  simulation.grid.emplace<RectilinearGrid>(grid);
  simulation.materials = namedMaterials(2);
  simulation.fractionAssociation = Association::Points;
  std::vector<double> first;
  std::vector<double> second;
  for (Index p = 0; p < grid.pointCount(); ++p)
  {
    const double x = grid.coordinates[0][p % 5];
    first.push_back(1.0 - x);
    second.push_back(x);
  }
  simulation.fractions = { ownedArray(first), ownedArray(second) };
  const ExtractedInterfaces result = extract(simulation);
  ASSERT_FALSE(result.interfaces.points.empty());
  for (const Vector& point : result.interfaces.points)
  {
    EXPECT_NEAR(point[0], 0.5, 1e-12);
  }
}
