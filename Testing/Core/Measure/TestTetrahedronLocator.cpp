#include "Geometry/TetrahedronLocator.h"
#include "Measuring.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace strata;
using namespace strata::test;

namespace
{
Box boxFarAway()
{
  Box box;
  box.add(Vector(1000.1, -2000.3, 0.7));
  box.add(Vector(1003.2, -1999.1, 5.9));
  return box;
}

TetrahedronLocator locatorOf(const Mesh& mesh)
{
  return TetrahedronLocator(mesh.points.data(), mesh.tetrahedra.data(), mesh.cellCount());
}

Vector pointAt(const Mesh& mesh, std::int64_t cell, const TetrahedronLocator::Weights& weights)
{
  Vector result = Vector::Zero();
  for (int i = 0; i < 4; ++i)
  {
    result += weights[i] * vertexPosition(mesh, mesh.tetrahedra[4 * cell + i]);
  }
  return result;
}

std::set<std::int64_t> cellsAt(const TetrahedronLocator& locator, const Vector& p)
{
  std::set<std::int64_t> cells;
  locator.visitCells(p, [&](std::int64_t cell, const TetrahedronLocator::Weights&) {
    EXPECT_TRUE(cells.insert(cell).second) << "cell " << cell << " was visited twice";
    return false;
  });
  return cells;
}
}

TEST(TetrahedronLocator, FindsTheCellAndTheWeightsOfAnyPointInside)
{
  const Mesh mesh = kuhnMesh(boxFarAway(), 7, { { "a" } }, {});
  const TetrahedronLocator locator = locatorOf(mesh);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 20000; ++i)
  {
    const Vector p =
      boxFarAway().lower + boxFarAway().size().cwiseProduct(Vector(unit(random), unit(random), unit(random)));
    TetrahedronLocator::Weights weights{};
    const std::int64_t cell = locator.anyCell(p, weights);
    ASSERT_GE(cell, 0);
    EXPECT_LT((pointAt(mesh, cell, weights) - p).norm(), 1e-11);
    EXPECT_GT(*std::min_element(weights.begin(), weights.end()), -1e-10);
  }
}

TEST(TetrahedronLocator, FindsTheSameCellsAsASearchOfAll)
{
  const Mesh mesh = kuhnMesh(unitBox(), 3, { { "a" } }, {});
  const TetrahedronLocator locator = locatorOf(mesh);
  std::mt19937_64 random(2);
  for (int i = 0; i < 500; ++i)
  {
    // Multiples of 1/6 often lie on faces, edges and vertices.
    const Vector p(double(random() % 7) / 6, double(random() % 7) / 6, double(random() % 7) / 6);
    std::set<std::int64_t> expected;
    TetrahedronLocator::Weights weights{};
    for (std::int64_t cell = 0; cell < mesh.cellCount(); ++cell)
    {
      if (locator.holds(cell, p, weights))
      {
        expected.insert(cell);
      }
    }
    EXPECT_EQ(cellsAt(locator, p), expected);
  }
}

TEST(TetrahedronLocator, FindsAllCellsRoundAVertexAnEdgeAndAFace)
{
  const Mesh mesh = kuhnMesh(unitBox(), 4, { { "a" } }, {});
  const TetrahedronLocator locator = locatorOf(mesh);
  // A Kuhn mesh has 24 cells round an inner vertex, 4 or 6 round an edge, 2 at a face.
  EXPECT_EQ(cellsAt(locator, { 0.5, 0.5, 0.5 }).size(), 24u);
  EXPECT_EQ(cellsAt(locator, { 0.625, 0.5, 0.5 }).size(), 6u);
  EXPECT_EQ(cellsAt(locator, { 0.625, 0.625, 0.625 }).size(), 6u);
  EXPECT_EQ(cellsAt(locator, { 0.625, 0.625, 0.5 }).size(), 4u);
  EXPECT_EQ(cellsAt(locator, { 0.7, 0.6, 0.5 }).size(), 2u);
  EXPECT_EQ(cellsAt(locator, { 0.7, 0.65, 0.55 }).size(), 1u);
}

TEST(TetrahedronLocator, FindsNothingOutsideAndInNoCells)
{
  const Mesh mesh = kuhnMesh(unitBox(), 2, { { "a" } }, {});
  const TetrahedronLocator locator = locatorOf(mesh);
  TetrahedronLocator::Weights weights{};
  EXPECT_EQ(locator.anyCell({ 1.0 + 1e-9, 0.5, 0.5 }, weights), -1);
  EXPECT_GE(locator.anyCell({ 1.0 + 1e-15, 0.5, 0.5 }, weights), 0);
  EXPECT_EQ(locator.anyCell({ std::nan(""), 0.5, 0.5 }, weights), -1);
  EXPECT_EQ(TetrahedronLocator(nullptr, nullptr, 0).anyCell({ 0, 0, 0 }, weights), -1);
}

TEST(TetrahedronLocator, SkipsCellsWithoutAVolumeAndTakesEitherOrientation)
{
  const std::vector<double> points = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  const std::vector<std::int64_t> cells = { 0, 1, 2, 2, 0, 2, 1, 3 };
  const TetrahedronLocator locator(points.data(), cells.data(), 2);
  TetrahedronLocator::Weights weights{};
  EXPECT_EQ(locator.anyCell({ 0.1, 0.2, 0.3 }, weights), 1);
  EXPECT_NEAR(weights[0], 0.4, 1e-15);
  EXPECT_NEAR(weights[1], 0.2, 1e-15);
  EXPECT_NEAR(weights[2], 0.1, 1e-15);
  EXPECT_NEAR(weights[3], 0.3, 1e-15);
}
