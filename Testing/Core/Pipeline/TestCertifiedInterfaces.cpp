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
