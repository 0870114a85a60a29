#include "Measuring.h"

#include "Model/Errors.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace strata;
using namespace strata::test;

namespace
{
const Materials materials = { { "a", true }, { "b", true }, { "c", false } };
const std::vector<Field> fields = { { "density", 1 } };
const FieldId density(0);
const OriginalVolumes thirds{ { 0.5, 0.25, 0.25 }, { 1.0, 2.0, std::nan("") } };

PointData noData()
{
  PointData data(unitBox(), materials, fields);
  data.setField(density, [](MaterialId, const Vector&, int) { return 0.0; });
  return data;
}

Mesh halfSpaces(int n, double border)
{
  Mesh mesh = kuhnMesh(unitBox(), n, materials, fields);
  setTwoMaterials(mesh, B, A, [border](const Vector& p) { return p.x() - border; });
  return mesh;
}

/// A left of x = 1/2; right of it, B below y = 1/2 and C above.
Mesh threeMaterials(int n)
{
  Mesh mesh = kuhnMesh(unitBox(), n, materials, fields);
  setDistances(mesh, A, [](const Vector& p) { return std::max(0.0, p.x() - 0.5); });
  setDistances(
    mesh, B, [](const Vector& p) { return std::hypot(std::max(0.0, 0.5 - p.x()), std::max(0.0, p.y() - 0.5)); });
  setDistances(
    mesh, C, [](const Vector& p) { return std::hypot(std::max(0.0, 0.5 - p.x()), std::max(0.0, 0.5 - p.y())); });
  return mesh;
}

Interfaces plane(double x)
{
  Interfaces interfaces;
  addSurface(interfaces, B, A, planeAcrossX(x, 3));
  return interfaces;
}
}

TEST(Volumes, OfHalfSpacesAreExactWhereverThePlaneCutsTheCells)
{
  for (const double x : { 0.1, 0.25, 0.43, 0.5, 0.999 })
  {
    const RepresentationErrors errors = measure(halfSpaces(4, x), noData(), plane(x), thirds);
    ASSERT_EQ(errors.volumes.size(), 3u);
    EXPECT_NEAR(errors.volumes[0].represented, x, 1e-6) << x;
    EXPECT_NEAR(errors.volumes[1].represented, 1.0 - x, 1e-6) << x;
    EXPECT_EQ(errors.volumes[2].represented, 0.0);
    EXPECT_NEAR(errors.volumes[0].represented + errors.volumes[1].represented, 1.0, 1e-13) << x;
  }
}

TEST(Volumes, OfThreeMaterialsRoundAnEdgeAreExact)
{
  const RepresentationErrors errors = measure(threeMaterials(4), noData(), {}, thirds);
  EXPECT_NEAR(errors.volumes[0].represented, 0.5, 1e-6);
  EXPECT_NEAR(errors.volumes[1].represented, 0.25, 1e-6);
  EXPECT_NEAR(errors.volumes[2].represented, 0.25, 1e-6);
}

TEST(Volumes, OriginalVolumesAndMassesAreHandedThrough)
{
  const RepresentationErrors errors = measure(halfSpaces(2, 0.5), noData(), plane(0.5), thirds);
  EXPECT_EQ(errors.volumes[1].original, 0.25);
  EXPECT_EQ(errors.volumes[1].originalMass, 2.0);
  EXPECT_TRUE(std::isnan(errors.volumes[2].originalMass));
  const OriginalVolumes withoutMasses{ thirds.volumes, {} };
  EXPECT_TRUE(std::isnan(measure(halfSpaces(2, 0.5), noData(), plane(0.5), withoutMasses).volumes[0].originalMass));
}

TEST(Volumes, MassIsTheIntegralOfTheLinearDensityOverTheRegion)
{
  // rho_A = 2 + x over 0 < x < s: 2 s + s^2 / 2. rho_B = 3 - y + 4 z over 1 - s: (3 - 1/2 + 2) (1 - s).
  const double s = 0.43;
  Mesh mesh = halfSpaces(4, s);
  setValues(mesh, density, A, [](const Vector& p, int) { return 2.0 + p.x(); });
  setValues(mesh, density, B, [](const Vector& p, int) { return 3.0 - p.y() + 4.0 * p.z(); });
  const RepresentationErrors errors = measure(mesh, noData(), plane(s), thirds);
  EXPECT_NEAR(errors.volumes[0].representedMass, 2.0 * s + 0.5 * s * s, 1e-6);
  EXPECT_NEAR(errors.volumes[1].representedMass, 4.5 * (1.0 - s), 1e-6);
  EXPECT_TRUE(std::isnan(errors.volumes[2].representedMass));
}

TEST(Volumes, MassIsNotANumberWhereARegionLacksValues)
{
  Mesh mesh = halfSpaces(4, 0.43);
  setValues(mesh, density, A, [](const Vector& p, int) { return p.x() > 0.4 ? std::nan("") : 1.0; });
  setValues(mesh, density, B, [](const Vector& p, int) { return p.x() < 0.2 ? std::nan("") : 1.0; });
  const RepresentationErrors errors = measure(mesh, noData(), plane(0.43), thirds);
  EXPECT_TRUE(std::isnan(errors.volumes[0].representedMass));
  EXPECT_NEAR(errors.volumes[1].representedMass, 0.57, 1e-6);
}

TEST(Volumes, OfRandomDistancesFillTheBox)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    Mesh mesh = kuhnMesh(unitBox(), 3, materials, fields);
    std::mt19937 random(seed);
    for (const MaterialId m : { A, B, C })
    {
      // Few different values: many ties.
      setDistances(mesh, m, [&random](const Vector&) { return random() % 3; });
    }
    const RepresentationErrors errors = measure(mesh, noData(), {}, thirds);
    double sum = 0.0;
    for (const VolumeErrorReport& report : errors.volumes)
    {
      EXPECT_GE(report.represented, 0.0);
      sum += report.represented;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12) << "seed " << seed;
  }
}

TEST(MisclassifiedVolume, IsZeroWhereTheRepresentationIsExact)
{
  const RepresentationErrors errors = measure(halfSpaces(4, 0.43), noData(), plane(0.43), thirds);
  EXPECT_NEAR(errors.misclassifiedVolume, 0.0, 1e-6);
}

TEST(MisclassifiedVolume, IsTheSlabBetweenAPlaneAndItsShiftedCopy)
{
  const RepresentationErrors errors = measure(halfSpaces(8, 0.43), noData(), plane(0.46), thirds);
  EXPECT_GT(errors.misclassifiedVolumeError, 0.0);
  EXPECT_LT(errors.misclassifiedVolumeError, 1e-3);
  EXPECT_NEAR(errors.misclassifiedVolume, 0.03, 4.0 * errors.misclassifiedVolumeError);
}

TEST(MisclassifiedVolume, FarFromTheOriginalInterfacesIsExact)
{
  // A slab of B, from 0.70 to 0.83, where no original interface is: seen though no sample is drawn there.
  Mesh mesh = kuhnMesh(unitBox(), 10, materials, fields);
  setTwoMaterials(mesh, B, A,
    [](const Vector& p) { return p.x() < 0.45 ? 0.2 - p.x() : (p.x() < 0.75 ? p.x() - 0.7 : 0.83 - p.x()); });
  const RepresentationErrors errors = [&] {
    Interfaces interfaces;
    addSurface(interfaces, A, B, planeAcrossX(0.2, 3));
    return measure(mesh, noData(), interfaces, thirds);
  }();
  EXPECT_NEAR(errors.misclassifiedVolume, 0.13, 1e-6);
}

TEST(MisclassifiedVolume, OfAPolyhedralSphereIsTheDifferenceOfTheVolumes)
{
  // The represented sphere has radius 0.35, the original one (finely inscribed) 0.3, with the same center. Between them
  // lies 4/3 pi (0.35^3 - 0.3^3); both are inscribed, by 1 % of the radius at most for edges of 1/16.
  const Vector center(0.5, 0.5, 0.5);
  Mesh mesh = kuhnMesh(unitBox(), 16, materials, fields);
  setTwoMaterials(mesh, A, B, [&](const Vector& p) { return (p - center).norm() - 0.35; });
  Interfaces interfaces;
  addSurface(interfaces, A, B, sphereSurface(center, 0.3, 3));
  const RepresentationErrors errors = measure(mesh, noData(), interfaces, thirds);
  const double expected = 4.0 / 3.0 * M_PI * (std::pow(0.35, 3) - std::pow(0.3, 3));
  EXPECT_NEAR(errors.misclassifiedVolume, expected, 0.06 * expected);
  // The regions are nested, so the misclassified volume is the difference of their volumes.
  double original = 0.0;
  for (const auto& [a, b, c] : sphereSurface(Vector::Zero(), 0.3, 3))
  {
    original += a.dot(b.cross(c)) / 6.0;
  }
  EXPECT_NEAR(
    errors.misclassifiedVolume, errors.volumes[1].represented - original, 4.0 * errors.misclassifiedVolumeError);
}

TEST(MisclassifiedVolume, RoundAnEdgeOfThreeMaterialsIsZero)
{
  Interfaces interfaces;
  addSurface(interfaces, B, A, parallelogram({ 0.5, 0, 0 }, 0.5 * Vector::UnitY(), Vector::UnitZ(), 2));
  addSurface(interfaces, C, A, parallelogram({ 0.5, 0.5, 0 }, 0.5 * Vector::UnitY(), Vector::UnitZ(), 2));
  addSurface(interfaces, C, B, parallelogram({ 0.5, 0.5, 0 }, Vector::UnitZ(), 0.5 * Vector::UnitX(), 2));
  EXPECT_NEAR(measure(threeMaterials(4), noData(), interfaces, thirds).misclassifiedVolume, 0.0, 1e-9);
}

TEST(MisclassifiedVolume, SaysWhichPartOfItIsNearAGapOfTheOriginalInterface)
{
  // The original plane is there for y < 1/4 alone; continued, it misses the represented one by 0.03 everywhere.
  Interfaces interfaces;
  addSurface(interfaces, B, A, parallelogram({ 0.46, 0, 0 }, 0.25 * Vector::UnitY(), Vector::UnitZ(), 4));
  const RepresentationErrors errors = measure(halfSpaces(8, 0.43), noData(), interfaces, thirds);
  EXPECT_NEAR(errors.misclassifiedVolume, 0.03, 4.0 * errors.misclassifiedVolumeError);
  EXPECT_NEAR(errors.misclassifiedNearGaps, 0.75 * 0.03, 4.0 * errors.misclassifiedVolumeError);
  EXPECT_EQ(measure(halfSpaces(8, 0.43), noData(), plane(0.46), thirds).misclassifiedNearGaps, 0.0);
}

TEST(MisclassifiedVolume, WithoutInterfacesTheMaterialWithTheLargestVolumeIsTheOriginal)
{
  EXPECT_NEAR(measure(halfSpaces(4, 0.43), noData(), {}, thirds).misclassifiedVolume, 0.57, 1e-6);
}

TEST(Measure, BadInputNamesTheThing)
{
  const PointData data = noData();
  Mesh otherMaterials = kuhnMesh(unitBox(), 1, { { "a" }, { "x" }, { "c" } }, fields);
  EXPECT_THROW(measure(otherMaterials, data, {}, thirds), InvalidInput);
  EXPECT_THROW(measure(halfSpaces(2, 0.5), data, {}, { { 1.0 }, {} }), InvalidInput);
  EXPECT_THROW(measure(halfSpaces(2, 0.5), data, {}, { { 1.0, 1.0, 1.0 }, { 1.0 } }), InvalidInput);
  Mesh wrongVertex = halfSpaces(2, 0.5);
  wrongVertex.tetrahedra[5] = wrongVertex.vertexCount();
  EXPECT_THROW(measure(wrongVertex, data, {}, thirds), InvalidInput);
  Mesh noMaterial = kuhnMesh(unitBox(), 1, materials, fields);
  EXPECT_THROW(measure(noMaterial, data, {}, thirds), InvalidInput);
  Interfaces wrongPoint = plane(0.5);
  wrongPoint.surfaces[0].triangles[1][1] = 1000;
  EXPECT_THROW(measure(halfSpaces(2, 0.5), data, wrongPoint, thirds), InvalidInput);
  Interfaces wrongMaterial = plane(0.5);
  wrongMaterial.surfaces[0].positive = MaterialId(3);
  EXPECT_THROW(measure(halfSpaces(2, 0.5), data, wrongMaterial, thirds), InvalidInput);
  const Mesh empty = kuhnMesh(unitBox(), 0, materials, fields);
  EXPECT_THROW(measure(empty, data, {}, thirds), InvalidInput);
}
