#include "Measuring.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

using namespace strata;
using namespace strata::test;

namespace
{
const Materials materials = { { "a", true }, { "b", true }, { "c", true } };
const OriginalVolumes volumes{ { 1.0, 0.0, 0.0 }, {} };
/// Hausdorff intervals are this wide.
const double width = hausdorffTolerance * std::sqrt(3.0);

PointData noData()
{
  return PointData(unitBox(), materials, {});
}

/// B where x is above the given value, A elsewhere.
Mesh halfSpaces(int n, double border)
{
  Mesh mesh = kuhnMesh(unitBox(), n, materials, {});
  setTwoMaterials(mesh, B, A, [border](const Vector& p) { return p.x() - border; });
  return mesh;
}

Interfaces planes(std::initializer_list<double> positions, int n = 3)
{
  Interfaces interfaces;
  for (const double x : positions)
  {
    addSurface(interfaces, B, A, planeAcrossX(x, n));
  }
  return interfaces;
}

void expectDistance(const DistanceInterval& interval, double truth)
{
  EXPECT_LE(interval.lower, truth + 1e-6);
  EXPECT_GE(interval.upper, truth - 1e-6);
  EXPECT_LE(interval.upper - interval.lower, width * (1.0 + 1e-9));
}
}

TEST(InterfaceErrors, APlaneIsRepresentedExactly)
{
  const RepresentationErrors errors = measure(halfSpaces(3, 0.4), noData(), planes({ 0.4 }), volumes);
  ASSERT_EQ(errors.interfaces.size(), 1u);
  const InterfaceErrorReport& report = errors.interfaces[0];
  EXPECT_EQ(report.positive, B);
  EXPECT_EQ(report.negative, A);
  EXPECT_EQ(report.vertices, 16);
  EXPECT_EQ(report.missing, 0);
  EXPECT_NEAR(report.largestVertexError, 0.0, 1e-6);
  expectDistance(report.distance.originalToRepresented, 0.0);
  expectDistance(report.distance.representedToOriginal, 0.0);
}

TEST(InterfaceErrors, APlaneThroughTheVerticesOfTheMeshIsThereOnce)
{
  const RepresentationErrors errors = measure(halfSpaces(4, 0.5), noData(), planes({ 0.5 }), volumes);
  ASSERT_EQ(errors.interfaces.size(), 1u);
  EXPECT_EQ(errors.interfaces[0].missing, 0);
  EXPECT_EQ(errors.interfaces[0].largestVertexError, 0.0);
  expectDistance(errors.interfaces[0].distance.originalToRepresented, 0.0);
  expectDistance(errors.interfaces[0].distance.representedToOriginal, 0.0);
}

TEST(InterfaceErrors, AShiftedPlaneIsAsFarAsItsShift)
{
  const RepresentationErrors errors = measure(halfSpaces(5, 0.4), noData(), planes({ 0.43 }), volumes);
  const InterfaceErrorReport& report = errors.interfaces[0];
  EXPECT_NEAR(report.largestVertexError, 0.03, 1e-6);
  expectDistance(report.distance.originalToRepresented, 0.03);
  expectDistance(report.distance.representedToOriginal, 0.03);
}

TEST(InterfaceErrors, ASheetThatIsNotRepresentedIsMissedOneWayOnly)
{
  // The sheet at 0.9 has no plane within its cell, but the plane d = 0, wherever it lies, is 0.5 away.
  const RepresentationErrors errors = measure(halfSpaces(4, 0.4), noData(), planes({ 0.4, 0.9 }), volumes);
  const InterfaceErrorReport& report = errors.interfaces[0];
  expectDistance(report.distance.originalToRepresented, 0.5);
  expectDistance(report.distance.representedToOriginal, 0.0);
  EXPECT_NEAR(report.largestVertexError, 0.5, 1e-6);
  EXPECT_NEAR(report.where.x(), 0.9, 1e-12);
}

TEST(InterfaceErrors, ASpuriousSheetIsSeenThoughNoOriginalVertexIsNear)
{
  // B is represented beyond 0.2 and beyond 0.4 to 0.7, A between; the original has the sheet at 0.2 alone.
  Mesh mesh = kuhnMesh(unitBox(), 10, materials, {});
  const auto side = [](const Vector& p) { return p.x() < 0.45 ? p.x() - 0.2 : std::abs(p.x() - 0.7) - 0.15; };
  setTwoMaterials(mesh, B, A, side);
  const RepresentationErrors errors = measure(mesh, noData(), planes({ 0.2 }), volumes);
  const InterfaceErrorReport& report = errors.interfaces[0];
  EXPECT_NEAR(report.largestVertexError, 0.0, 1e-6);
  expectDistance(report.distance.originalToRepresented, 0.0);
  // The farther spurious sheet lies at 0.85.
  expectDistance(report.distance.representedToOriginal, 0.65);
}

TEST(InterfaceErrors, ASphereConvergesWithTheSquareOfTheEdge)
{
  const Vector center(0.5, 0.5, 0.5);
  const double radius = 0.3;
  Interfaces interfaces;
  addSurface(interfaces, B, A, sphereSurface(center, radius, 3));
  for (const int n : { 8, 16 })
  {
    Mesh mesh = kuhnMesh(unitBox(), n, materials, {});
    setTwoMaterials(mesh, B, A, [&](const Vector& p) { return (p - center).norm() - radius; });
    const RepresentationErrors errors = measure(mesh, noData(), interfaces, volumes);
    const InterfaceErrorReport& report = errors.interfaces[0];
    // Linear interpolation of the distance over a cell of diameter D is off by at most D^2 / 8 times the largest
    // curvature, 1 / (radius - D), in the cells at the sphere; the distance then grows with slope about 1.
    const double diameter = std::sqrt(3.0) / n;
    const double bound = 1.5 * diameter * diameter / 8.0 / (radius - diameter);
    EXPECT_LE(report.distance.originalToRepresented.lower, bound) << n;
    EXPECT_LE(report.distance.representedToOriginal.lower, bound) << n;
    EXPECT_LE(report.largestVertexError, bound) << n;
    EXPECT_GT(report.largestVertexError, 0.0) << n;
  }
}

TEST(InterfaceErrors, ADropletThatVanishedIsInfinitelyFar)
{
  Mesh mesh = kuhnMesh(unitBox(), 2, materials, {});
  setDistances(mesh, A, [](const Vector&) { return 0.0; });
  setDistances(mesh, B, [](const Vector&) { return 0.1; });
  Interfaces interfaces;
  addSurface(interfaces, B, A, sphereSurface({ 0.3, 0.3, 0.3 }, 0.05, 1));
  const RepresentationErrors errors = measure(mesh, noData(), interfaces, volumes);
  EXPECT_TRUE(std::isinf(errors.interfaces[0].distance.originalToRepresented.lower));
  EXPECT_TRUE(std::isinf(errors.interfaces[0].largestVertexError));
}

TEST(InterfaceErrors, VerticesInCellsThatLackAMaterialAreInfinite)
{
  Mesh mesh = halfSpaces(4, 0.4);
  // B is absent from all cells left of x = 1/4.
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    if (vertexPosition(mesh, vertex).x() < 0.2)
    {
      mesh.distances[1][vertex] = std::nanf("");
    }
  }
  const RepresentationErrors errors = measure(mesh, noData(), planes({ 0.4, 0.1 }, 3), volumes);
  EXPECT_EQ(errors.interfaces[0].missing, 16);
  EXPECT_TRUE(std::isinf(errors.interfaces[0].largestVertexError));
  EXPECT_NEAR(errors.interfaces[0].where.x(), 0.1, 1e-12);
}

TEST(InterfaceErrors, PairsThatOnlyTheRepresentationHasAreReported)
{
  const RepresentationErrors errors = measure(halfSpaces(3, 0.4), noData(), {}, volumes);
  ASSERT_EQ(errors.interfaces.size(), 1u);
  EXPECT_EQ(errors.interfaces[0].vertices, 0);
  EXPECT_TRUE(std::isinf(errors.interfaces[0].distance.representedToOriginal.lower));
  EXPECT_EQ(errors.interfaces[0].distance.originalToRepresented.upper, 0.0);
}

TEST(InterfaceErrors, APairThatTouchesOnOneSideOnlyHasRegionsAtAFiniteDistance)
{
  // A film of C between A and B is not shown where A and B touch instead. B also bounds C at 0.9, which is shown.
  Mesh mesh = kuhnMesh(unitBox(), 10, materials, {});
  setDistances(mesh, A, [](const Vector& p) { return std::max(0.0, p.x() - 0.42); });
  setDistances(mesh, B, [](const Vector& p) { return std::max({ 0.0, 0.42 - p.x(), p.x() - 0.9 }); });
  setDistances(mesh, C, [](const Vector& p) { return std::max(0.0, 0.9 - p.x()); });
  Interfaces interfaces;
  addSurface(interfaces, C, A, planeAcrossX(0.42, 3));
  addSurface(interfaces, B, C, planeAcrossX(0.45, 3));
  addSurface(interfaces, C, B, planeAcrossX(0.9, 3));
  const RepresentationErrors errors = measure(mesh, noData(), interfaces, volumes);
  ASSERT_EQ(errors.interfaces.size(), 3u);
  EXPECT_TRUE(std::isinf(errors.interfaces[0].distance.representedToOriginal.lower)) << "A and B";
  EXPECT_TRUE(std::isinf(errors.interfaces[1].distance.originalToRepresented.lower)) << "A and C";
  ASSERT_EQ(errors.regions.size(), 3u);
  EXPECT_EQ(errors.regions[0].material, A);
  expectDistance(errors.regions[0].distance.originalToRepresented, 0.0);
  expectDistance(errors.regions[0].distance.representedToOriginal, 0.0);
  expectDistance(errors.regions[1].distance.originalToRepresented, 0.03);
  expectDistance(errors.regions[1].distance.representedToOriginal, 0.03);
  expectDistance(errors.regions[2].distance.originalToRepresented, 0.48);
  expectDistance(errors.regions[2].distance.representedToOriginal, 0.0);
}

TEST(InterfaceErrors, AMaterialThatVanishedHasARegionInfinitelyFar)
{
  Interfaces interfaces = planes({ 0.4 });
  addSurface(interfaces, C, A, sphereSurface({ 0.2, 0.5, 0.5 }, 0.05, 1));
  const RepresentationErrors errors = measure(halfSpaces(3, 0.4), noData(), interfaces, volumes);
  ASSERT_EQ(errors.regions.size(), 3u);
  // The farthest point of the small ball from the plane at 0.4, but for its corners.
  EXPECT_NEAR(errors.regions[0].distance.originalToRepresented.upper, 0.25, 0.01);
  expectDistance(errors.regions[1].distance.originalToRepresented, 0.0);
  EXPECT_TRUE(std::isinf(errors.regions[2].distance.originalToRepresented.lower));
}

TEST(InterfaceErrors, MaterialsThatMeetOnlyOnFacesOfTheMeshHaveAnInterfaceThere)
{
  // Cells hold one material each: A left of x = 1/2, B right of it. No cell has both.
  Mesh mesh = kuhnMesh(unitBox(), 4, materials, {});
  const auto present = [](bool is) { return is ? 0.0 : std::nan(""); };
  setDistances(mesh, A, [&](const Vector& p) { return present(p.x() < 0.6); });
  setDistances(mesh, B, [&](const Vector& p) { return present(p.x() > 0.4); });
  const RepresentationErrors errors = measure(mesh, noData(), planes({ 0.5 }), volumes);
  ASSERT_EQ(errors.interfaces.size(), 1u);
  expectDistance(errors.interfaces[0].distance.originalToRepresented, 0.0);
  expectDistance(errors.interfaces[0].distance.representedToOriginal, 0.0);
}

TEST(InterfaceErrors, ThreeMaterialsRoundAnEdgeMeetInThreeInterfaces)
{
  // A left of x = 1/2; right of it, B below y = 1/2 and C above. The regions' borders lie on planes of the mesh.
  Mesh mesh = kuhnMesh(unitBox(), 4, materials, {});
  setDistances(mesh, A, [](const Vector& p) { return std::max(0.0, p.x() - 0.5); });
  setDistances(
    mesh, B, [](const Vector& p) { return std::hypot(std::max(0.0, 0.5 - p.x()), std::max(0.0, p.y() - 0.5)); });
  setDistances(
    mesh, C, [](const Vector& p) { return std::hypot(std::max(0.0, 0.5 - p.x()), std::max(0.0, 0.5 - p.y())); });
  Interfaces interfaces;
  addSurface(interfaces, B, A, parallelogram({ 0.5, 0, 0 }, 0.5 * Vector::UnitY(), Vector::UnitZ(), 2));
  addSurface(interfaces, C, A, parallelogram({ 0.5, 0.5, 0 }, 0.5 * Vector::UnitY(), Vector::UnitZ(), 2));
  addSurface(interfaces, C, B, parallelogram({ 0.5, 0.5, 0 }, Vector::UnitZ(), 0.5 * Vector::UnitX(), 2));
  const RepresentationErrors errors = measure(mesh, noData(), interfaces, volumes);
  ASSERT_EQ(errors.interfaces.size(), 3u);
  for (const InterfaceErrorReport& report : errors.interfaces)
  {
    EXPECT_NEAR(report.largestVertexError, 0.0, 1e-6);
    expectDistance(report.distance.originalToRepresented, 0.0);
    expectDistance(report.distance.representedToOriginal, 0.0);
  }
}

TEST(InterfaceErrors, APerturbedDistanceIsFound)
{
  // Vertex (0.4, 0.6, 0.6), left of the plane at 0.45: its signed distance of -0.05 becomes -0.15. On the edge to the
  // right, where the distance at 0.6 is 0.15, the zero moves from 0.45 to the middle, 0.5.
  Mesh mesh = halfSpaces(5, 0.45);
  const Index vertex = 2 + 6 * (3 + 6 * 3);
  ASSERT_NEAR(mesh.distances[1][vertex], 0.05, 1e-6);
  mesh.distances[1][vertex] = 0.15f;
  const RepresentationErrors errors = measure(mesh, noData(), planes({ 0.45 }, 20), volumes);
  const InterfaceErrorReport& report = errors.interfaces[0];
  expectDistance(report.distance.representedToOriginal, 0.05);
  EXPECT_GT(report.distance.originalToRepresented.lower, 0.02);
  EXPECT_LE(report.distance.originalToRepresented.lower, 0.05);
  EXPECT_GT(report.largestVertexError, 0.02);
  EXPECT_LT((report.where - vertexPosition(mesh, vertex)).norm(), 0.2 * std::sqrt(3.0));
}

TEST(InterfaceErrors, OneAndTwoThreadsGiveTheSameBytes)
{
  const Vector center(0.5, 0.5, 0.5);
  Mesh mesh = kuhnMesh(unitBox(), 9, materials, {});
  setTwoMaterials(mesh, B, A, [&](const Vector& p) { return (p - center).norm() - 0.4; });
  Interfaces interfaces;
  addSurface(interfaces, B, A, sphereSurface(center, 0.4, 3));
  const RepresentationErrors many = measure(mesh, noData(), interfaces, volumes);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const RepresentationErrors single = measure(mesh, noData(), interfaces, volumes);
  EXPECT_EQ(many.interfaces[0].largestVertexError, single.interfaces[0].largestVertexError);
  EXPECT_EQ(
    many.interfaces[0].distance.originalToRepresented.lower, single.interfaces[0].distance.originalToRepresented.lower);
  EXPECT_EQ(
    many.interfaces[0].distance.representedToOriginal.upper, single.interfaces[0].distance.representedToOriginal.upper);
  EXPECT_EQ(many.volumes[0].represented, single.volumes[0].represented);
  EXPECT_EQ(many.misclassifiedVolume, single.misclassifiedVolume);
  EXPECT_EQ(many.misclassifiedVolumeError, single.misclassifiedVolumeError);
}
