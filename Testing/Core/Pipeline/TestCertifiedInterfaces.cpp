#include "Pipeline.h"

#include "../Measure/Measuring.h"
#include "Model/Errors.h"
#include "Support/MeshAssertions.h"
#include "Support/SphereCase.h"

#include <tbb/global_control.h>

namespace strata
{
namespace
{
using namespace test;

constexpr double bound = 0.03;

/// Materials without fields in the unit cube, and their interfaces.
struct Regions
{
  std::shared_ptr<const NativeData> native;
  Interfaces interfaces;
};

std::shared_ptr<const NativeData> withoutFields(std::size_t materials)
{
  Simulation simulation = fractionSimulation(cubeGrid(2), materials, [&](const Box&) {
    std::vector<double> fractions(materials, 0.0);
    fractions.back() = 1.0;
    return fractions;
  });
  for (Material& material : simulation.materials)
  {
    material.hasFields = false;
  }
  Progress progress;
  return readNativeData(simulation, {}, progress);
}

Regions twoMaterials(const Triangles& triangles)
{
  return { withoutFields(2), interfaceBetween(triangles, MaterialId(1), MaterialId(0)) };
}

/// A ball, and a droplet far from it that is smaller than the bound.
Regions ballAndDroplet()
{
  Triangles triangles = sphereSurface(Vector(0.4, 0.45, 0.5), 0.27, 3);
  const Triangles droplet = sphereSurface(Vector(0.87, 0.81, 0.83), 0.02, 1);
  triangles.insert(triangles.end(), droplet.begin(), droplet.end());
  return twoMaterials(triangles);
}

/// A wall of material 0 that is thinner than the bound, from side to side.
Regions thinWall()
{
  constexpr double thickness = 0.01;
  Triangles triangles = parallelogram(Vector(0.3, 0, 0), Vector(0.2, 0, 1), Vector::UnitY(), 3);
  const Triangles right = parallelogram(Vector(0.3 + thickness, 0, 0), Vector::UnitY(), Vector(0.2, 0, 1), 3);
  triangles.insert(triangles.end(), right.begin(), right.end());
  return twoMaterials(triangles);
}

/// Three materials that meet along a line, oblique to the lattice.
Regions threeMaterials()
{
  const Vector line(0.45, 0.5, 0.0);
  Interfaces interfaces;
  addSurface(interfaces, A, B, parallelogram(line, Vector(0.55, 0, 0), Vector::UnitZ(), 4));
  addSurface(interfaces, B, C, parallelogram(line, Vector(-0.45, 0.5, 0), Vector::UnitZ(), 4));
  addSurface(interfaces, C, A, parallelogram(line, Vector(-0.45, -0.5, 0), Vector::UnitZ(), 4));
  return { withoutFields(3), interfaces };
}

const Vector ballBesideSheet(0.5, 0.5, 0.25);
constexpr double radiusBesideSheet = 0.15;

/// A sheet of a material that also fills a ball, too thin to be shown: from side to side between two others (which
/// touch in the representation alone), or a plate in the plane between them (the material touches the upper one there
/// alone). The sheet's corner comes first.
Regions ballAndSheet(double width)
{
  const Vector low(0.5 - 0.5 * width, 0.5 - 0.5 * width, 0.6);
  const Vector x = width * Vector::UnitX();
  const Vector y = width * Vector::UnitY();
  const Vector up = 1e-6 * Vector::UnitZ();
  const int n = static_cast<int>(8.0 * width);
  Interfaces interfaces;
  addSurface(interfaces, A, B, parallelogram(low, x, y, n));
  addSurface(interfaces, C, A, parallelogram(low + up, x, y, n));
  addSurface(interfaces, B, A, sphereSurface(ballBesideSheet, radiusBesideSheet, 2));
  if (width == 1.0)
  {
    return { withoutFields(3), interfaces };
  }
  addSurface(interfaces, C, A, parallelogram(low, x, up, n));
  addSurface(interfaces, C, A, parallelogram(low + x, y, up, n));
  addSurface(interfaces, C, A, parallelogram(low + x + y, -x, up, n));
  addSurface(interfaces, C, A, parallelogram(low + y, -y, up, n));
  Triangles around;
  for (const std::array<Vector, 3>& triangle :
    parallelogram(Vector(0, 0, low.z()), Vector::UnitX(), Vector::UnitY(), 8))
  {
    const Vector fromCenter = (triangle[0] + triangle[1] + triangle[2]) / 3.0 - Vector(0.5, 0.5, low.z());
    if (fromCenter.cwiseAbs().maxCoeff() > 0.5 * width)
    {
      around.push_back(triangle);
    }
  }
  addSurface(interfaces, C, B, around);
  return { withoutFields(3), interfaces };
}

Regions ballAndPlate()
{
  return ballAndSheet(0.5);
}

Regions ballAndFilm()
{
  return ballAndSheet(1.0);
}

BuildOptions certified(int maximumLevel = 60)
{
  BuildOptions build;
  build.nativeElements = NativeElements::Cells;
  build.maximumLevel = maximumLevel;
  return build;
}

SelectOptions within(double interfaceError, ErrorMethod method = ErrorMethod::Direct)
{
  SelectOptions select;
  select.bounds = { interfaceError, {} };
  select.errorMethod = method;
  return select;
}

Mesh meshOf(const Regions& regions, const SelectOptions& select, const BuildOptions& build = certified())
{
  Progress progress;
  return Multiresolution(regions.native, regions.interfaces, build).level(select, progress);
}

RepresentationErrors measured(const Regions& regions, const Mesh& mesh)
{
  return measure(mesh, *regions.native, regions.interfaces, { std::vector<double>(mesh.materials.size(), 0.0), {} });
}

/// The largest distance, both ways and over all pairs, that some point is known to have.
double largestDistanceIn(const RepresentationErrors& errors)
{
  double largest = 0.0;
  for (const InterfaceErrorReport& report : errors.interfaces)
  {
    largest =
      std::max({ largest, report.distance.originalToRepresented.lower, report.distance.representedToOriginal.lower });
  }
  return largest;
}

class InterfacesCertifiedBy : public testing::TestWithParam<ErrorMethod>
{
};

INSTANTIATE_TEST_SUITE_P(EveryMethod, InterfacesCertifiedBy,
  testing::Values(ErrorMethod::Direct, ErrorMethod::Saturated, ErrorMethod::Fitted, ErrorMethod::Accumulated));

TEST_P(InterfacesCertifiedBy, TheTwoSidedHausdorffDistanceIsWithinTheBound)
{
  for (const Regions& regions : { ballAndDroplet(), thinWall(), threeMaterials() })
  {
    const Mesh mesh = meshOf(regions, within(bound, GetParam()));
    expectConforming(mesh, regions.native->box());
    EXPECT_TRUE(mesh.achieved.boundMet);
    EXPECT_EQ("bounds met", mesh.achieved.stoppedBy);
    const RepresentationErrors errors = measured(regions, mesh);
    EXPECT_EQ(regions.interfaces.surfaces.size(), errors.interfaces.size());
    EXPECT_LE(largestDistanceIn(errors), mesh.achieved.interfaceError);
    EXPECT_LE(mesh.achieved.interfaceError, bound);
  }
}

TEST_P(InterfacesCertifiedBy, WithErrorsAtPointsTheSameBoundsLeaveSurfacesOut)
{
  // What makes the test above one that can fail.
  double largest = 0.0;
  for (const Regions& regions : { ballAndDroplet(), thinWall() })
  {
    largest = std::max(largest, largestDistanceIn(measured(regions, meshOf(regions, within(bound, GetParam()), {}))));
  }
  EXPECT_GT(largest, bound);
}

TEST_P(InterfacesCertifiedBy, ErrorsAreTrueEvenWhereTheMaximumLevelStopsRefinement)
{
  for (const Regions& regions : { ballAndDroplet(), threeMaterials() })
  {
    const Mesh mesh = meshOf(regions, within(0.1 * bound, GetParam()), certified(9));
    EXPECT_FALSE(mesh.achieved.boundMet);
    EXPECT_EQ("maximum level", mesh.achieved.stoppedBy);
    EXPECT_GT(mesh.achieved.interfaceError, 0.1 * bound);
    EXPECT_LE(largestDistanceIn(measured(regions, mesh)), mesh.achieved.interfaceError);
  }
}

TEST(CertifiedInterfacesOfLevels, TheWayToALevelDoesNotMatter)
{
  const Regions regions = threeMaterials();
  Progress progress;
  for (const ErrorMethod method : { ErrorMethod::Direct, ErrorMethod::Saturated, ErrorMethod::Fitted })
  {
    const Mesh expected = meshOf(regions, within(0.08, method));
    Multiresolution slid(regions.native, regions.interfaces, certified());
    slid.level(within(0.2, method), progress);
    slid.level(within(0.06, ErrorMethod::Direct), progress);
    expectSameMesh(expected, slid.level(within(0.08, method), progress));
  }
}

TEST(CertifiedInterfacesOfLevels, OneThreadAndTwoGiveTheSameBytes)
{
  const Regions regions = threeMaterials();
  for (const ErrorMethod method : { ErrorMethod::Direct, ErrorMethod::Fitted })
  {
    const Mesh expected = meshOf(regions, within(0.06, method));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    expectSameMesh(expected, meshOf(regions, within(0.06, method)));
  }
}

TEST(CertifiedInterfacesOfLevels, SaturatedLevelsAreNestedAndTellTheirErrors)
{
  const Regions regions = ballAndDroplet();
  Multiresolution hierarchy(regions.native, regions.interfaces, certified());
  Progress progress;
  SelectOptions select = within(0.4, ErrorMethod::Saturated);
  select.finestBounds = { bound, {} };
  Mesh coarser = hierarchy.level(select, progress);
  for (const double finer : { 0.2, 0.1, 0.05, bound })
  {
    select.bounds.interfaceError = finer;
    Mesh mesh = hierarchy.level(select, progress);
    expectRefines(mesh, coarser);
    EXPECT_LE(largestDistanceIn(measured(regions, mesh)), mesh.achieved.interfaceError);
    EXPECT_EQ(mesh.achieved.boundMet, mesh.achieved.interfaceError <= finer);
    coarser = std::move(mesh);
  }
  EXPECT_TRUE(coarser.achieved.boundMet);
}

TEST(CertifiedInterfacesOfLevels, ABudgetTellsTheErrorsThatItLeaves)
{
  const Regions regions = ballAndDroplet();
  const Index needed = meshOf(regions, within(bound)).cellCount();
  Mesh smaller;
  for (const Index most : { needed / 4, needed / 2, needed - 1, needed })
  {
    SelectOptions select = within(bound);
    select.maximumNumberOfCells = most;
    Mesh mesh = meshOf(regions, select);
    EXPECT_LE(mesh.cellCount(), most);
    EXPECT_EQ(most == needed, mesh.achieved.boundMet);
    EXPECT_EQ(most == needed ? "bounds met" : "maximum number of cells", mesh.achieved.stoppedBy);
    EXPECT_LE(largestDistanceIn(measured(regions, mesh)), mesh.achieved.interfaceError);
    if (smaller.cellCount() > 0)
    {
      expectRefines(mesh, smaller);
    }
    smaller = std::move(mesh);
  }
}

TEST(CertifiedInterfacesOfLevels, AnAlmostFlatDiscIsReportedAndEndsRefinement)
{
  // A disc that no cell is small enough to show, beside a ball.
  Triangles both = sphereSurface(Vector(0.7, 0.7, 0.7), 0.2, 2);
  for (std::array<Vector, 3> triangle : sphereSurface(Vector::Zero(), 0.1, 2))
  {
    for (Vector& p : triangle)
    {
      p = Vector(0.3, 0.3, 0.31) + Vector(p.x(), p.y(), 1e-5 * p.z() + 0.1 * p.x());
    }
    both.push_back(triangle);
  }
  const Regions regions = twoMaterials(both);
  const Mesh mesh = meshOf(regions, within(bound));
  EXPECT_FALSE(mesh.achieved.boundMet);
  EXPECT_EQ("parts of interfaces too thin for the bound", mesh.achieved.stoppedBy);
  EXPECT_LT(mesh.cellCount(), 100000);
  EXPECT_LE(largestDistanceIn(measured(regions, mesh)), mesh.achieved.interfaceError);
}

class PairsWithoutCounterpart : public testing::TestWithParam<ErrorMethod>
{
};

INSTANTIATE_TEST_SUITE_P(
  EveryMethod, PairsWithoutCounterpart, testing::Values(ErrorMethod::Direct, ErrorMethod::Fitted));

TEST_P(PairsWithoutCounterpart, AreInfinitelyFarButTheirRegionsBoundariesAreNot)
{
  for (const Regions& regions : { ballAndPlate(), ballAndFilm() })
  {
    const Mesh mesh = meshOf(regions, within(0.2, GetParam()));
    const RepresentationErrors errors = measured(regions, mesh);
    EXPECT_FALSE(mesh.achieved.boundMet);
    EXPECT_TRUE(std::isinf(mesh.achieved.interfaceError));
    EXPECT_TRUE(std::isinf(largestDistanceIn(errors)));
    ASSERT_TRUE(mesh.achieved.regionError.has_value());
    ASSERT_EQ(3u, errors.regions.size());
    double largest = 0.0;
    double upper = 0.0;
    for (const RegionErrorReport& report : errors.regions)
    {
      const HausdorffDistance& distance = report.distance;
      largest = std::max({ largest, distance.originalToRepresented.lower, distance.representedToOriginal.lower });
      upper = std::max({ upper, distance.originalToRepresented.upper, distance.representedToOriginal.upper });
    }
    // The corners of the sheet, from the ball: the nearest that is left of the material's boundary.
    const double corner = (regions.interfaces.points.front() - ballBesideSheet).norm() - radiusBesideSheet;
    EXPECT_LE(largest, *mesh.achieved.regionError);
    EXPECT_NEAR(corner, largest, 0.2);
    EXPECT_LE(*mesh.achieved.regionError, 1.2 * upper);
  }
}

TEST(CertifiedInterfacesOfLevels, WithACounterpartForEveryPairTheRegionsAreNoFartherThanTheInterfaces)
{
  for (const Regions& regions : { ballAndDroplet(), threeMaterials() })
  {
    const Mesh mesh = meshOf(regions, within(bound));
    ASSERT_TRUE(mesh.achieved.regionError.has_value());
    EXPECT_LE(*mesh.achieved.regionError, mesh.achieved.interfaceError);
    for (const RegionErrorReport& report : measured(regions, mesh).regions)
    {
      EXPECT_LE(report.distance.originalToRepresented.lower, *mesh.achieved.regionError);
      EXPECT_LE(report.distance.representedToOriginal.lower, *mesh.achieved.regionError);
    }
  }
  EXPECT_FALSE(meshOf(threeMaterials(), within(bound), {}).achieved.regionError.has_value());
}

TEST(CertifiedInterfacesOfLevels, TheUserCanStopIt)
{
  const Regions regions = threeMaterials();
  Multiresolution hierarchy(regions.native, regions.interfaces, certified());
  Progress stopped([](const std::string&, double) { return false; });
  EXPECT_THROW(hierarchy.level(within(0.005), stopped), Cancelled);
  Progress progress;
  expectSameMesh(meshOf(regions, within(0.1)), hierarchy.level(within(0.1), progress));
}
}
}
