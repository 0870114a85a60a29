#include "Measuring.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

using namespace strata;
using namespace strata::test;

namespace
{
const FieldId density(0);
const FieldId velocity(1);
const std::vector<Field> fields = { { "density", 1 }, { "velocity", 3 } };
const Materials materials = { { "a", true }, { "b", true } };

/// Linear fields that differ between the materials; exact in float at multiples of 1/16.
double linearField(FieldId field, MaterialId m, const Vector& p, int c)
{
  const double sign = m == A ? 1.0 : -3.0;
  return field == density ? sign * (1.0 + 2.0 * p.x() - p.y() + 0.5 * p.z()) : sign * p[(c + 1) % 3] + c;
}

/// A unit cube of n^3 boxes; A where x < 1/2.
Mesh twoHalves(int n)
{
  Mesh mesh = kuhnMesh(unitBox(), n, materials, fields);
  setTwoMaterials(mesh, B, A, [](const Vector& p) { return p.x() - 0.5; });
  for (const FieldId field : { density, velocity })
  {
    for (const MaterialId m : { A, B })
    {
      setValues(mesh, field, m, [&](const Vector& p, int c) { return linearField(field, m, p, c); });
    }
  }
  return mesh;
}

PointData twoHalvesData(int n)
{
  PointData data(unitBox(), materials, fields);
  data.setField(density, [](MaterialId m, const Vector& p, int c) { return linearField(density, m, p, c); });
  data.setField(velocity, [](MaterialId m, const Vector& p, int c) { return linearField(velocity, m, p, c); });
  data.addGrid(n, [](const Vector& p) { return MaterialSet::of(p.x() < 0.5 ? A : B); });
  return data;
}

const OriginalVolumes halves{ { 0.5, 0.5 }, {} };
}

TEST(FieldErrors, LinearFieldsHaveNone)
{
  const RepresentationErrors errors = measure(twoHalves(3), twoHalvesData(8), {}, halves);
  ASSERT_EQ(errors.fields.size(), 4u);
  for (const FieldErrorReport& report : errors.fields)
  {
    EXPECT_EQ(report.samples, 8 * 8 * 4);
    EXPECT_EQ(report.missing, 0);
    EXPECT_NEAR(report.largest, 0.0, 1e-6);
  }
}

TEST(FieldErrors, AreTakenInTheSamplesOwnMaterialOnBothSidesOfTheRepresentedInterface)
{
  // The represented interface is off by 0.3, the fields aren't: m's own linear function has no error anywhere.
  Mesh mesh = twoHalves(4);
  setTwoMaterials(mesh, B, A, [](const Vector& p) { return p.x() - 0.8; });
  for (const FieldErrorReport& report : measure(mesh, twoHalvesData(8), {}, halves).fields)
  {
    EXPECT_NEAR(report.largest, 0.0, 1e-6);
  }
}

TEST(FieldErrors, AConstantOffsetIsLargestMeanAndRootMeanSquare)
{
  PointData data = twoHalvesData(8);
  data.setField(density,
    [](MaterialId m, const Vector& p, int c) { return linearField(density, m, p, c) + (m == A ? 0.25 : 0.0); });
  const RepresentationErrors errors = measure(twoHalves(4), data, {}, halves);
  const FieldErrorReport& report = fieldReport(errors, density, A);
  EXPECT_NEAR(report.largest, 0.25, 1e-6);
  EXPECT_NEAR(report.mean, 0.25, 1e-6);
  EXPECT_NEAR(report.rootMeanSquare, 0.25, 1e-6);
  EXPECT_NEAR(fieldReport(errors, density, B).largest, 0.0, 1e-6);
}

TEST(FieldErrors, OneWrongSampleIsFoundAndCountedOnce)
{
  PointData data = twoHalvesData(4);
  const Vector wrong(0.3, 0.7, 0.2);
  data.addSample(wrong, MaterialSet::of(A));
  data.setField(density,
    [&](MaterialId m, const Vector& p, int c) { return linearField(density, m, p, c) + (p == wrong ? 2.0 : 0.0); });
  const RepresentationErrors errors = measure(twoHalves(4), data, {}, halves);
  const FieldErrorReport& report = fieldReport(errors, density, A);
  EXPECT_EQ(report.samples, 33);
  EXPECT_NEAR(report.largest, 2.0, 1e-6);
  EXPECT_NEAR(report.mean, 2.0 / 33, 1e-6);
  EXPECT_NEAR(report.rootMeanSquare, 2.0 / std::sqrt(33.0), 1e-6);
  EXPECT_EQ(report.where, wrong);
}

TEST(FieldErrors, TheErrorOfAVectorIsTheLengthOfTheDifference)
{
  PointData data = twoHalvesData(4);
  data.setField(velocity, [](MaterialId m, const Vector& p, int c) {
    return linearField(velocity, m, p, c) + (c == 0 ? 3.0 : (c == 1 ? 4.0 : 0.0));
  });
  const RepresentationErrors errors = measure(twoHalves(4), data, {}, halves);
  EXPECT_NEAR(fieldReport(errors, velocity, A).largest, 5.0, 1e-6);
}

TEST(FieldErrors, OfAQuadraticAreItsInterpolationErrorOnTheEdges)
{
  // x^2 on an edge along x of length h: interpolated at its middle, off by h^2/4.
  Mesh mesh = twoHalves(4);
  setValues(mesh, density, A, [](const Vector& p, int) { return p.x() * p.x(); });
  PointData data(unitBox(), materials, fields);
  data.setField(velocity, [](MaterialId m, const Vector& p, int c) { return linearField(velocity, m, p, c); });
  data.setField(density, [](MaterialId, const Vector& p, int) { return p.x() * p.x(); });
  data.addSample({ 0.125, 0.25, 0.5 }, MaterialSet::of(A));
  data.addSample({ 0.25, 0.375, 0.5 }, MaterialSet::of(A));
  const RepresentationErrors errors = measure(mesh, data, {}, halves);
  const FieldErrorReport& report = fieldReport(errors, density, A);
  EXPECT_NEAR(report.largest, 1.0 / 64, 1e-9);
  EXPECT_NEAR(report.mean, 0.5 / 64, 1e-9);
  EXPECT_EQ(report.where, Vector(0.125, 0.25, 0.5));
}

TEST(FieldErrors, ASampleThatCountsForTwoMaterialsIsComparedWithBoth)
{
  PointData data = twoHalvesData(4);
  data.addSample({ 0.5, 0.5, 0.5 }, MaterialSet::of(A) | MaterialSet::of(B));
  const RepresentationErrors errors = measure(twoHalves(4), data, {}, halves);
  EXPECT_EQ(fieldReport(errors, density, A).samples, 33);
  EXPECT_EQ(fieldReport(errors, density, B).samples, 33);
}

TEST(FieldErrors, SamplesInCellsWithoutTheMaterialsValuesAreInfinite)
{
  Mesh mesh = twoHalves(4);
  // Without the value at this vertex, the cells round it lack A's density.
  const Index vertex = 1 + 5 * (1 + 5 * 1);
  mesh.values[0][0][vertex] = std::nanf("");
  PointData data = twoHalvesData(4);
  data.addSample({ 0.26, 0.27, 0.28 }, MaterialSet::of(A));
  const RepresentationErrors errors = measure(mesh, data, {}, halves);
  const FieldErrorReport& report = fieldReport(errors, density, A);
  EXPECT_TRUE(std::isinf(report.largest));
  // The other samples are the centers of boxes, on the diagonal that six cells share; eight boxes have the vertex.
  EXPECT_GE(report.missing, 1);
  EXPECT_LE(report.missing, 9);
  EXPECT_NEAR(report.mean, 0.0, 1e-6);
  EXPECT_EQ(fieldReport(errors, density, B).missing, 0);
  EXPECT_NEAR(fieldReport(errors, velocity, A).largest, 0.0, 1e-6);
}

TEST(FieldErrors, ASampleOnASharedFaceTakesTheCellThatHasTheValues)
{
  PointData data(unitBox(), materials, fields);
  data.setField(density, [](MaterialId m, const Vector& p, int c) { return linearField(density, m, p, c); });
  data.setField(velocity, [](MaterialId m, const Vector& p, int c) { return linearField(velocity, m, p, c); });
  for (int i = 0; i < 17 * 17; ++i)
  {
    data.addSample({ 0.5, i % 17 / 16.0, i / 17 / 16.0 }, MaterialSet::of(A));
  }
  // The samples lie on x = 1/2; A's values are missing on one side of it.
  for (const bool beyond : { true, false })
  {
    Mesh mesh = twoHalves(4);
    setValues(mesh, density, A, [beyond](const Vector& p, int) {
      const bool missing = beyond ? p.x() > 0.6 : p.x() < 0.4;
      return missing ? std::nan("") : linearField(density, A, p, 0);
    });
    const RepresentationErrors errors = measure(mesh, data, {}, halves);
    EXPECT_EQ(fieldReport(errors, density, A).missing, 0);
    EXPECT_NEAR(fieldReport(errors, density, A).largest, 0.0, 1e-6);
  }
}

TEST(FieldErrors, SamplesOutsideTheMeshAreInfinite)
{
  PointData data = twoHalvesData(2);
  data.addSample({ -0.001, 0.5, 0.5 }, MaterialSet::of(A));
  const RepresentationErrors errors = measure(twoHalves(2), data, {}, halves);
  EXPECT_EQ(fieldReport(errors, density, A).missing, 1);
  EXPECT_TRUE(std::isinf(fieldReport(errors, density, A).largest));
}

TEST(FieldErrors, SamplesAtWhichAFieldIsNotKnownDontCount)
{
  PointData data = twoHalvesData(4);
  data.setField(density,
    [](MaterialId m, const Vector& p, int c) { return m == B ? std::nan("") : linearField(density, m, p, c); });
  const RepresentationErrors errors = measure(twoHalves(4), data, {}, halves);
  EXPECT_EQ(errors.fields.size(), 3u);
  EXPECT_NEAR(fieldReport(errors, density, A).largest, 0.0, 1e-6);
}

TEST(FieldErrors, AnyVertexValueThatIsPerturbedIsFound)
{
  const PointData data = twoHalvesData(16);
  for (const Index vertex : { Index{ 0 }, Index{ 31 }, Index{ 62 } })
  {
    Mesh mesh = twoHalves(4);
    mesh.values[0][0][vertex] += 0.5f;
    const RepresentationErrors errors = measure(mesh, data, {}, halves);
    const FieldErrorReport& report = fieldReport(errors, density, A);
    // The closest samples are an eighth of an edge away along each axis: the vertex's hat function is 3/4 or more.
    EXPECT_GT(report.largest, 0.5 * 0.75 - 1e-6) << "vertex " << vertex;
    EXPECT_LT(report.largest, 0.5) << "vertex " << vertex;
    EXPECT_LT((report.where - vertexPosition(mesh, vertex)).norm(), 0.25 * std::sqrt(3.0));
  }
}

TEST(FieldErrors, OneAndTwoThreadsGiveTheSameBytes)
{
  Mesh mesh = twoHalves(7);
  const PointData data = twoHalvesData(40);
  const RepresentationErrors many = measure(mesh, data, {}, halves);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const RepresentationErrors single = measure(mesh, data, {}, halves);
  ASSERT_EQ(many.fields.size(), single.fields.size());
  for (std::size_t i = 0; i < many.fields.size(); ++i)
  {
    EXPECT_EQ(many.fields[i].largest, single.fields[i].largest);
    EXPECT_EQ(many.fields[i].mean, single.fields[i].mean);
    EXPECT_EQ(many.fields[i].rootMeanSquare, single.fields[i].rootMeanSquare);
    EXPECT_EQ(many.fields[i].where, single.fields[i].where);
  }
}
