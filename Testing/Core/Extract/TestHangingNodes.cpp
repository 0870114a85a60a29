#include "ExtractCases.h"

#include "Extract/GridTopology.h"
#include "Octrees.h"

#include <random>

using namespace strata;
using namespace strata::test;

namespace
{
const Box unitBox{ Vector::Zero(), Vector::Ones() };

/// Every face of the mesh lies in the box or is a face of two cells; every cell keeps its volume.
void expectConforming(const Octree& tree)
{
  Progress progress;
  const auto topology = makeGridTopology(tree.grid, progress);
  EXPECT_TRUE(topology->warnings().empty());
  CellFaces faces;
  for (Index cell = 0; cell < tree.grid.cellCount(); ++cell)
  {
    topology->faces(cell, faces);
    for (std::int32_t f = 0; f < faces.count(); ++f)
    {
      Box box;
      for (std::int32_t i = faces.start[f]; i < faces.start[f + 1]; ++i)
      {
        box.add(topology->point(faces.corners[i]));
      }
      const bool inSide =
        (box.lower.array() == box.upper.array() && (box.lower.array() == 0.0 || box.upper.array() == 1.0)).any();
      EXPECT_EQ(faces.neighbours[f] < 0, inSide) << "cell " << cell;
    }
    EXPECT_NEAR(topology->volume(cell), tree.boxes[cell].volume(), 1e-13);
    EXPECT_LT((topology->center(cell) - tree.boxes[cell].center()).norm(), 1e-14);
  }
}

bool divideAtRandom(const Box& box, int level, unsigned seed)
{
  const Vector c = box.center() * 1e4;
  std::seed_seq seeds{ seed, unsigned(level), unsigned(c[0]), unsigned(c[1]), unsigned(c[2]) };
  std::mt19937 random(seeds);
  return random() % 3 == 0;
}

Octree randomOctree(unsigned seed, int cubes = 3, int ratio = 2)
{
  return makeOctree(cubes, ratio, 3, [=](const Box& box, int level) { return divideAtRandom(box, level, seed); });
}
}

TEST(HangingNodes, TwoLevelsConform)
{
  const Octree tree = makeOctree(4, 2, 1, [](const Box& box, int) { return box.center()[0] > 0.5; });
  EXPECT_EQ(tree.grid.cellCount(), 32 + 256);
  expectConforming(tree);
}

TEST(HangingNodes, AnyTreesConform)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    expectConforming(randomOctree(seed));
  }
  expectConforming(randomOctree(9, 2, 3));
}

TEST(HangingNodes, ASphereAcrossTwoLevelsIsClosedAndKeepsItsVolume)
{
  const Distance distance = sphere({ 0.5, 0.51, 0.49 }, 0.3);
  const ExtractedInterfaces uniform = extract(fractionSimulation(cubeGrid(16), 2, insideOf(distance)));
  for (int axis = 0; axis < 3; ++axis)
  {
    const Octree tree = makeOctree(8, 2, 1, [=](const Box& box, int) { return box.center()[axis] > 0.5; });
    const ExtractedInterfaces result = extract(fractionsOnOctree(tree, 2, insideOf(distance)));
    expectSound(result.interfaces, 2, unitBox);
    EXPECT_NEAR(result.volumes[0].reconstructed, uniform.volumes[0].reconstructed, 1e-4 * 0.113);
    EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6);
    EXPECT_NEAR(result.volumes[0].reconstructed, enclosedVolume(result.interfaces, MaterialId(0)), 1e-12);
    EXPECT_LT(largestCellError(result, 1.0 / 512.0), 1e-3);
    EXPECT_LT(meanDistance(result.interfaces, distance), 0.03 / 8);
  }
}

TEST(HangingNodes, ThreeMaterialsOnAnyTreeAreClosedAndFillTheBox)
{
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    const Octree tree = randomOctree(seed, 4);
    const FractionsOf fractions = nested({ sphere({ 0.45, 0.5, 0.55 }, 0.25), sphere({ 0.55, 0.5, 0.5 }, 0.38) });
    for (bool correct : { false, true })
    {
      const ExtractedInterfaces result = extract(fractionsOnOctree(tree, 3, fractions), correct);
      expectSound(result.interfaces, 3, unitBox);
      double sum = 0.0;
      for (const VolumeReport& report : result.volumes)
      {
        sum += report.reconstructed;
        EXPECT_TRUE(!correct || std::abs(report.reconstructed - report.given) < 1e-6) << "seed " << seed;
      }
      EXPECT_NEAR(sum, 1.0, 1e-12);
      EXPECT_NEAR(result.volumes[0].reconstructed, enclosedVolume(result.interfaces, MaterialId(0)), 1e-12);
    }
  }
}

TEST(HangingNodes, APlaneAcrossLevelsKeepsItsPlace)
{
  const Vector normal = Vector(0.3, 0.5, 1.0).normalized();
  const Vector point(0.5, 0.5, 0.5);
  const Octree tree =
    makeOctree(6, 2, 2, [](const Box& box, int) { return (box.center() - Vector(1, 1, 0.6)).norm() < 0.7; });
  const ExtractedInterfaces result = extract(fractionsOnOctree(tree, 2, [&](const Box& box) {
    const double below = fractionBelowPlane(box, normal, normal.dot(point));
    return std::vector<double>{ below, 1.0 - below };
  }));
  expectSound(result.interfaces, 2, unitBox);
  EXPECT_LT(meanDistance(result.interfaces, [&](const Vector& x) { return normal.dot(x - point); }), 0.02 / 6);
  EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6);
}

TEST(HangingNodes, ATurnedTreeIsBoundedByTheOutside)
{
  Octree tree = randomOctree(3);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector(0.2, 0.5, 0.8).normalized()).toRotationMatrix();
  for (Vector& point : tree.grid.points)
  {
    point = turn * point;
  }
  Simulation simulation = fractionsOnOctree(tree, 3, [](const Box& box) {
    const double inside = fractionInside(box, sphere({ 0.5, 0.5, 0.5 }, 0.6), 4);
    return std::vector<double>{ inside, 1.0 - inside, 0.0 };
  });
  simulation.materials[2] = { "outside", false };
  const ExtractedInterfaces result = extract(simulation);
  EXPECT_TRUE(result.warnings.empty());
  Box nowhere; // every edge must be matched
  nowhere.add(Vector::Constant(100.0));
  nowhere.add(Vector::Constant(101.0));
  expectSound(result.interfaces, 3, nowhere);
  EXPECT_NEAR(enclosedVolume(result.interfaces, MaterialId(2)), -1.0, 1e-9);
}

TEST(HangingNodes, ALinearFunctionAtPointsIsExact)
{
  const Octree tree = randomOctree(1);
  Simulation simulation;
  simulation.grid.emplace<UnstructuredGrid>(tree.grid);
  simulation.materials = namedMaterials(2);
  simulation.fractionAssociation = Association::Points;
  std::vector<double> first;
  std::vector<double> second;
  for (const Vector& point : tree.grid.points)
  {
    second.push_back(0.4 * point[0] + 0.3 * point[1] + 0.2 * point[2]);
    first.push_back(1.0 - second.back());
  }
  simulation.fractions = { ownedArray(first), ownedArray(second) };
  const ExtractedInterfaces result = extract(simulation);
  ASSERT_FALSE(result.interfaces.points.empty());
  expectSound(result.interfaces, 2, unitBox);
  for (const Vector& point : result.interfaces.points)
  {
    EXPECT_NEAR(0.4 * point[0] + 0.3 * point[1] + 0.2 * point[2], 0.5, 1e-12);
  }
}

TEST(HangingNodes, MaterialIdsOnAnyTreeAreClosed)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    const Octree tree = randomOctree(seed);
    Simulation simulation;
    simulation.grid.emplace<UnstructuredGrid>(tree.grid);
    simulation.materials = namedMaterials(2);
    double inside = 0.0;
    for (const Box& box : tree.boxes)
    {
      const bool isInside = (box.center() - Vector(0.5, 0.5, 0.5)).cwiseAbs().maxCoeff() < 0.3;
      simulation.materialIds.push_back(isInside ? 0 : 1);
      inside += isInside ? box.volume() : 0.0;
    }
    const ExtractedInterfaces result = extract(simulation);
    expectSound(result.interfaces, 2, unitBox);
    EXPECT_NEAR(enclosedVolume(result.interfaces, MaterialId(0)), inside, 1e-12);
    EXPECT_NEAR(result.volumes[0].reconstructed, inside, 1e-12);
    for (const auto& t : surfaceBetween(result.interfaces, 0, 1).triangles)
    {
      const std::vector<Vector>& p = result.interfaces.points;
      EXPECT_GT((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm(), 1e-6);
    }
  }
}
