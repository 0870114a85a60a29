#include "SampledSimulations.h"
#include "UnstructuredGrids.h"

#include "Native/CellCentroids.h"
#include "Native/SampleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace strata;
using namespace strata::test;

namespace
{
constexpr std::array<CellShape, 5> shapes = { CellShape::Tetrahedron, CellShape::Hexahedron, CellShape::Wedge,
  CellShape::Pyramid, CellShape::Polyhedron };

std::vector<Vector> samplePoints(const UnstructuredGrid& grid, Association association)
{
  Progress progress;
  return association == Association::Cells ? cellCentroids(grid, progress) : grid.points;
}

/// Two materials, each sample of which belongs to material 0 where the function is positive.
Simulation pureMaterials(const UnstructuredGrid& grid, const std::function<double(const Vector&)>& block0,
  const Function& field, Association association)
{
  const std::vector<Vector> points = samplePoints(grid, association);
  Simulation simulation;
  simulation.grid = grid;
  simulation.materials = { { "block", true }, { "rod", true } };
  simulation.fractionAssociation = association;
  const auto fraction = [&](MaterialId m, const Vector& p) { return (m == block) == (block0(p) > 0.0) ? 1.0 : 0.0; };
  simulation.fractions = { sampled(fraction, block, points), sampled(fraction, rod, points) };
  simulation.fields.push_back(scalarField("density", field, 2, association, points));
  return simulation;
}

/// The unit box, sheared and stretched.
UnstructuredGrid shearedGrid(int n, CellShape shape)
{
  UnstructuredGrid grid = unstructured(boxGrid(n, n, n, 1.1), shape);
  for (Vector& p : grid.points)
  {
    p = Vector(p.x() + 0.3 * p.y(), p.y(), 0.7 * p.z() - 0.2 * p.x());
  }
  return grid;
}
}

TEST(CellCentroids, AreCentresOfVolume)
{
  UnstructuredGrid grid;
  // A frustum: bases of area 4 and 1, height 1. The centroid's height is (4 + 2 * 2 + 3 * 1) / (4 (4 + 2 + 1)).
  grid.points = { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 }, { -.5, -.5, 1 }, { .5, -.5, 1 },
    { .5, .5, 1 }, { -.5, .5, 1 }, { 0, 0, 4 } };
  addCell(grid, CellShape::Hexahedron, { 0, 1, 2, 3, 4, 5, 6, 7 });
  addCell(grid, CellShape::Pyramid, { 0, 1, 2, 3, 8 });
  addCell(grid, CellShape::Tetrahedron, { 0, 1, 2, 8 });
  addCell(grid, CellShape::Wedge, { 0, 1, 2, 4, 5, 6 });
  Progress progress;
  const std::vector<Vector> centroids = cellCentroids(grid, progress);
  EXPECT_NEAR((centroids[0] - Vector(0, 0, 11.0 / 28.0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((centroids[1] - Vector(0, 0, 1)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((centroids[2] - Vector(0.25, -0.25, 1)).norm(), 0.0, 1e-14);
  // Half of the frustum, cut by the plane x = y; x = -y by symmetry, and the same height.
  EXPECT_NEAR(centroids[3].z(), 11.0 / 28.0, 1e-14);
  EXPECT_NEAR(centroids[3].x() + centroids[3].y(), 0.0, 1e-14);
}

TEST(CellCentroids, OfACellWithoutVolumeAreTheMeanOfItsCorners)
{
  UnstructuredGrid grid;
  grid.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
  addCell(grid, CellShape::Tetrahedron, { 0, 1, 2, 3 });
  Progress progress;
  EXPECT_EQ(cellCentroids(grid, progress)[0], Vector(0.5, 0.5, 0.0));
}

TEST(SampleTree, FindsTheNearestSamplesInOrder)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<Vector> points;
    std::vector<std::uint32_t> samples;
    for (std::uint32_t i = 0; i < 10 + 40 * seed; ++i)
    {
      // Coarse coordinates, so that many distances are equal.
      points.push_back((8.0 * randomPoint(random)).array().floor());
      if (random() % 3 != 0)
      {
        samples.push_back(i);
      }
    }
    Progress progress;
    const SampleTree tree(points, samples, progress);
    for (int query = 0; query < 20; ++query)
    {
      const Vector point = (8.0 * randomPoint(random)).array().floor();
      std::vector<Neighbor> expected;
      for (const std::uint32_t sample : samples)
      {
        expected.push_back({ (points[sample] - point).squaredNorm(), sample });
      }
      std::sort(expected.begin(), expected.end());
      Neighbors found(16);
      tree.nearest(points, point, found);
      ASSERT_EQ(found.count, static_cast<int>(std::min<std::size_t>(16, expected.size())));
      for (int i = 0; i < found.count; ++i)
      {
        EXPECT_EQ(found[i].sample, expected[static_cast<std::size_t>(i)].sample);
      }
    }
  }
}

TEST(UnstructuredData, ReproducesEachMaterialsLinearFieldInAllShapes)
{
  const Vector normal = Vector(1.0, 0.5, 0.25).normalized();
  const auto side = [&](const Vector& p) { return normal.dot(p) - 0.45; };
  for (const CellShape shape : shapes)
  {
    for (const Association association : { Association::Cells, Association::Points })
    {
      std::mt19937 random(11);
      const Function field = randomLinear(random);
      const auto data = read(pureMaterials(shearedGrid(6, shape), side, field, association));
      for (int i = 0; i < 50; ++i)
      {
        const Vector corner = randomPoint(random);
        const Vector point(corner.x() + 0.3 * corner.y(), corner.y(), 0.7 * corner.z() - 0.2 * corner.x());
        const Vector closest = point - side(point) * normal;
        for (const MaterialId m : { block, rod })
        {
          const bool inside = (m == block) == (side(point) > 0.0);
          for (const GhostMethod method : { GhostMethod::DataThenLinear, GhostMethod::Linear })
          {
            EXPECT_NEAR(valueAt(*data, m, point, inside, closest, method), field(m, point), 1e-9);
          }
        }
      }
    }
  }
}

TEST(UnstructuredData, AgreesWithTheSameGridReadAsRectilinear)
{
  const RectilinearGrid grid = boxGrid(5, 6, 7, 1.05);
  std::mt19937 random(4);
  const Function field = randomLinear(random);
  const auto half = [](const Vector& p) { return p.x() < 0.5 ? 1.0 : 0.0; };
  const auto rectilinear = read(twoMaterials(grid, half, field));
  const auto cells = read(pureMaterials(unstructured(grid, CellShape::Hexahedron), half, field, Association::Cells));
  ASSERT_EQ(rectilinear->sampleCount(), cells->sampleCount());
  EXPECT_DOUBLE_EQ(rectilinear->range(FieldId(0)), cells->range(FieldId(0)));
  for (SampleIndex sample = 0; sample < cells->sampleCount(); ++sample)
  {
    EXPECT_NEAR((positionOf(*rectilinear, sample) - positionOf(*cells, sample)).norm(), 0.0, 1e-14);
    EXPECT_EQ(materialsOf(*rectilinear, sample), materialsOf(*cells, sample));
  }
  for (int i = 0; i < 100; ++i)
  {
    const Vector point = randomPoint(random);
    const Vector closest(0.5, point.y(), point.z());
    for (const MaterialId m : { block, rod })
    {
      const bool inside = (m == block) == (point.x() < 0.5);
      EXPECT_NEAR(valueAt(*rectilinear, m, point, inside, closest), valueAt(*cells, m, point, inside, closest), 1e-10);
    }
  }
}

TEST(UnstructuredData, GivesTheSamplesOwnValueAtItsPosition)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Function noise = [&](MaterialId, const Vector&) { return number(random); };
  const auto data = read(pureMaterials(
    shearedGrid(5, CellShape::Wedge), [](const Vector& p) { return p.x() - 0.5; }, noise, Association::Cells));
  for (SampleIndex sample = 0; sample < data->sampleCount(); ++sample)
  {
    for (const MaterialId m : materialsOf(*data, sample))
    {
      const Vector position = positionOf(*data, sample);
      EXPECT_EQ(valueAt(*data, m, position), sampleValue(*data, FieldId(0), m, sample));
      const Vector near = position + Vector(1e-9, 0.0, 0.0);
      EXPECT_NEAR(valueAt(*data, m, near), sampleValue(*data, FieldId(0), m, sample), 1e-6);
    }
  }
}

TEST(UnstructuredData, ConvergesWithSecondOrder)
{
  const Function field = [](MaterialId m, const Vector& p) { return (1.0 + m.value) * p.squaredNorm(); };
  std::array<double, 2> errors{};
  for (std::size_t refinement = 0; refinement < 2; ++refinement)
  {
    const int n = refinement == 0 ? 8 : 16;
    const auto data = read(pureMaterials(
      unstructured(boxGrid(n, n, n), CellShape::Hexahedron), [](const Vector& p) { return p.x() - 0.5; }, field,
      Association::Cells));
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i)
    {
      // Within a cell of the interface on either side, away from the box's sides.
      Vector point = randomPoint(random, 0.2, 0.8);
      point.x() = 0.5 + std::uniform_real_distribution<double>(-1.0, 1.0)(random) / n;
      const Vector closest(0.5, point.y(), point.z());
      for (const MaterialId m : { block, rod })
      {
        const bool inside = (m == block) == (point.x() > 0.5);
        errors[refinement] =
          std::max(errors[refinement], std::abs(valueAt(*data, m, point, inside, closest) - field(m, point)));
      }
    }
  }
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.7) << errors[0] << ' ' << errors[1];
}

TEST(UnstructuredData, TakesTheMeanOfTheNearestSamplesAsConstant)
{
  const auto data = read(pureMaterials(
    unstructured(boxGrid(4, 4, 4), CellShape::Hexahedron), [](const Vector& p) { return 0.5 - p.x(); },
    [](MaterialId, const Vector& p) { return p.x(); }, Association::Cells));
  const Vector closest(0.375, 0.625, 0.625);
  // At a sample's position the other samples have no weight.
  EXPECT_NEAR(valueAt(*data, block, Vector(1, 1, 1), false, closest, GhostMethod::Constant), 0.375, 1e-10);
  const double between = valueAt(*data, block, Vector(1, 1, 1), false, Vector(0.5, 0.5, 0.5), GhostMethod::Constant);
  EXPECT_GE(between, 0.125);
  EXPECT_LE(between, 0.375);
}

TEST(UnstructuredData, ExtendsAMaterialOfOneSampleAsAConstant)
{
  const auto data = read(pureMaterials(
    unstructured(boxGrid(4, 4, 4), CellShape::Hexahedron),
    [](const Vector& p) { return (p - Vector(0.125, 0.125, 0.125)).norm() - 0.01; },
    [](MaterialId m, const Vector&) { return m == rod ? 7.0 : 1.0; }, Association::Cells));
  for (const GhostMethod method : { GhostMethod::DataThenLinear, GhostMethod::Linear, GhostMethod::Constant })
  {
    EXPECT_EQ(valueAt(*data, rod, Vector(1, 1, 1), false, Vector(0.2, 0.2, 0.2), method), 7.0);
  }
}

TEST(UnstructuredData, InterpolatesAMaterialsDataAcrossTheInterface)
{
  // Two cell layers hold 0.4 of the block: the interface lies before their centres, and data beyond it. The
  // field is far from linear, so that only the near samples tell its value.
  const RectilinearGrid grid = boxGrid(4, 4, 4);
  const auto fraction = [](const Vector& p) { return p.x() < 0.25 ? 1.0 : p.x() < 0.75 ? 0.4 : 0.0; };
  const Function field = [](MaterialId, const Vector& p) { return p.x() > 0.25 && p.x() < 0.5 ? 5.0 : 1.0; };
  Simulation simulation = twoMaterials(grid, fraction, field);
  for (const bool asHexahedra : { false, true })
  {
    if (asHexahedra)
    {
      simulation.grid = unstructured(grid, CellShape::Hexahedron);
    }
    const auto data = read(simulation);
    const Vector sample(0.375, 0.375, 0.375);
    const Vector closest(0.35, 0.375, 0.375);
    EXPECT_NEAR(valueAt(*data, block, sample, false, closest), 5.0, 1e-12);
    EXPECT_NEAR(valueAt(*data, block, sample + Vector(0.01, 0.01, 0.0), false, closest), 5.0, 0.5);
    EXPECT_NE(valueAt(*data, block, sample, false, Vector(0.2, 0.375, 0.375), GhostMethod::Linear), 5.0);
  }
}

TEST(UnstructuredData, InterpolatesPointDataWithinCells)
{
  // The functions that cells of each shape can hold exactly, in a grid of parallelepipeds.
  const Function trilinear = [](MaterialId, const Vector& p) {
    // In the coordinates before the shear.
    const double y = p.y();
    const double x = p.x() - 0.3 * y;
    return (1.0 + x) * (2.0 - y) + 0.5 * x;
  };
  const Function linear = [](MaterialId, const Vector& p) { return 1.0 + p.x() - 2.0 * p.y() + 3.0 * p.z(); };
  for (const CellShape shape : shapes)
  {
    const Function& field = shape == CellShape::Hexahedron ? trilinear : linear;
    const auto data = read(pureMaterials(
      shearedGrid(4, shape), [](const Vector&) { return 1.0; }, field, Association::Points));
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i)
    {
      Vector p = randomPoint(random);
      p = Vector(p.x() + 0.3 * p.y(), p.y(), 0.7 * p.z() - 0.2 * p.x());
      EXPECT_NEAR(valueAt(*data, block, p), field(block, p), 1e-9);
    }
  }
}

TEST(UnstructuredData, ContinuesPointDataPastTheGridWithoutAJump)
{
  const Function field = [](MaterialId, const Vector& p) { return p.squaredNorm() + p.x() * p.y(); };
  for (const CellShape shape : { CellShape::Tetrahedron, CellShape::Hexahedron, CellShape::Wedge, CellShape::Pyramid })
  {
    const auto data = read(pureMaterials(
      unstructured(boxGrid(4, 4, 4), shape), [](const Vector&) { return 1.0; }, field, Association::Points));
    std::mt19937 random(4);
    for (int i = 0; i < 50; ++i)
    {
      Vector on = randomPoint(random);
      on.x() = 1.0;
      const Vector beyond = on + Vector(1e-6, 0, 0);
      EXPECT_NEAR(valueAt(*data, block, on), valueAt(*data, block, beyond, false, on), 1e-4);
    }
  }
}
