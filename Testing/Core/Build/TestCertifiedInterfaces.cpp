#include "CertifiedCells.h"

#include <gtest/gtest.h>

#include <cmath>

namespace strata
{
namespace
{
using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two materials without fields in the unit cube, between triangles.
struct TwoMaterials
{
  std::shared_ptr<const NativeData> native;
  Interfaces interfaces;
};

TwoMaterials separatedBy(const Triangles& triangles)
{
  Simulation simulation = fractionSimulation(cubeGrid(2), 2, [](const Box&) {
    return std::vector<double>{ 0.0, 1.0 };
  });
  simulation.materials[0].hasFields = false;
  simulation.materials[1].hasFields = false;
  Progress progress;
  return { readNativeData(simulation, {}, progress), interfaceBetween(triangles, MaterialId(1), MaterialId(0)) };
}

CertifiedCells grown(const TwoMaterials& data, double bound, int maximumLevel = 40)
{
  return CertifiedCells(data.native, data.interfaces, { bound, {} }, maximumLevel);
}

/// Whether a cell represents some of material 0.
bool represents(const Hierarchy& hierarchy, CellId cell)
{
  for (const VertexId corner : hierarchy.cell(cell).corners)
  {
    const float* own = hierarchy.valuesOf(corner, MaterialId(0));
    const float* other = hierarchy.valuesOf(corner, MaterialId(1));
    if (own && other && *own < *other)
    {
      return true;
    }
  }
  return false;
}

Index leavesThatRepresent(const CertifiedCells& cells)
{
  Index count = 0;
  for (Index c = 0; c < cells.cellCount(); ++c)
  {
    const bool isLeaf = !cells.hierarchy().cell(CellId(c)).firstChild.valid();
    count += isLeaf && represents(cells.hierarchy(), CellId(c)) ? 1 : 0;
  }
  return count;
}

TEST(CertifiedInterfaces, NoPointOfATriangleIsFartherFromThePlaneThanItsCellClaims)
{
  // Large triangles: most cells have none of their corners.
  const TwoMaterials data = separatedBy(sphereSurface(Vector(0.45, 0.55, 0.5), 0.3, 1));
  const CertifiedCells cells = grown(data, 0.004);
  const Hierarchy& hierarchy = cells.hierarchy();
  std::mt19937 random(3);
  double closest = infinity;
  int compared = 0;
  for (const CellId cell : randomCells(hierarchy, 400, 4))
  {
    const std::array<Vector, 4> corners = cornerPositions(hierarchy, cell);
    const Barycentric barycentric(corners);
    if (hierarchy.materialsOf(cell).size() < 2)
    {
      continue;
    }
    const MaterialCorners inside = materialCorners(hierarchy, hierarchy.cell(cell), MaterialId(0));
    const MaterialCorners outside = materialCorners(hierarchy, hierarchy.cell(cell), MaterialId(1));
    const LinearFunction in = representedFunction(barycentric, inside, 0);
    const LinearFunction out = representedFunction(barycentric, outside, 0);
    const LinearFunction plane = { in.constant - out.constant, in.gradient - out.gradient };
    double size = 0.0;
    for (const Vector& a : corners)
    {
      size = std::max({ size, (a - corners[0]).norm(), (a - corners[1]).norm(), (a - corners[2]).norm() });
    }
    double seen = 0.0;
    for (const auto& t : data.interfaces.surfaces[0].triangles)
    {
      for (int i = 0; i < 300; ++i)
      {
        std::array<double, 4> weights = randomWeights(random);
        const Vector p = (weights[0] + weights[3]) * data.interfaces.points[static_cast<std::size_t>(t[0])] +
                         weights[1] * data.interfaces.points[static_cast<std::size_t>(t[1])] +
                         weights[2] * data.interfaces.points[static_cast<std::size_t>(t[2])];
        if (barycentric.contains(p, 0.0))
        {
          seen = std::max(seen, std::min(distanceToPlane(plane, p), size));
        }
      }
    }
    ASSERT_LE(seen, static_cast<double>(hierarchy.interfaceError(cell)));
    if (seen > 1e-4)
    {
      closest = std::min(closest, static_cast<double>(hierarchy.interfaceError(cell)) / seen);
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
  EXPECT_LT(0.99 * closest, 1.0);
}

TEST(CertifiedInterfaces, APlaneHasNoErrorWhereverItLies)
{
  for (const double height : { 0.5, 0.3, 0.5 + 1e-12, 0.25 - 1e-15 })
  {
    const TwoMaterials data = separatedBy(parallelogram(Vector(0, 0, height), Vector::UnitX(), Vector::UnitY(), 3));
    const CertifiedCells cells = grown(data, 1e-6);
    EXPECT_EQ(6, cells.cellCount()) << height;
    const TwoMaterials oblique =
      separatedBy(parallelogram(Vector(-1, -1, height - 1.5), Vector(3, 0, 1.5), Vector(0, 3, 1.5), 1));
    EXPECT_EQ(6, grown(oblique, 1e-6).cellCount());
  }
}

TEST(CertifiedInterfaces, ADropletBetweenVerticesIsFoundUnlessItIsSmallerThanTheBound)
{
  for (const double radius : { 0.02, 0.003 })
  {
    const TwoMaterials data = separatedBy(sphereSurface(Vector(0.31, 0.37, 0.43), radius, 2));
    EXPECT_GT(leavesThatRepresent(grown(data, 0.3 * radius)), 0) << radius;
    // Where it may vanish, the cells round it are no larger than the bound.
    const CertifiedCells coarse = grown(data, 4.0 * radius);
    EXPECT_LT(coarse.cellCount(), 4000);
  }
}

TEST(CertifiedInterfaces, ASheetWithinCellsIsFoundWhenTheBoundIsItsThickness)
{
  for (const double x : { 0.5001, 1.0 / 3.0, 0.26 })
  {
    constexpr double thickness = 0.02;
    // Material 0 between two planes: the left one's normal points left, the right one's right.
    Triangles sheet = parallelogram(Vector(x, 0, 0), Vector::UnitZ(), Vector::UnitY(), 2);
    const Triangles right = parallelogram(Vector(x + thickness, 0, 0), Vector::UnitY(), Vector::UnitZ(), 2);
    sheet.insert(sheet.end(), right.begin(), right.end());
    const TwoMaterials data = separatedBy(sheet);
    const CertifiedCells cells = grown(data, 0.5 * thickness);
    // Every column of the box shows it.
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 20; ++i)
    {
      const Vector p(x + 0.5 * thickness, unit(random), unit(random));
      bool found = false;
      for (Index c = 0; c < cells.cellCount() && !found; ++c)
      {
        const CellId cell(c);
        const Barycentric barycentric(cornerPositions(cells.hierarchy(), cell));
        found = !cells.hierarchy().cell(cell).firstChild.valid() && represents(cells.hierarchy(), cell) &&
                barycentric.contains(p, 0.3);
      }
      EXPECT_TRUE(found) << x;
    }
  }
}

TEST(CertifiedInterfaces, TheErrorsOfABallFallWithSecondOrderAndItsCellsAreFewMoreThanWithPoints)
{
  const TwoMaterials data = separatedBy(sphereSurface(Vector(0.45, 0.55, 0.5), 0.3, 4));
  Index last = 0;
  for (const double bound : { 0.016, 0.004 })
  {
    const ErrorBounds bounds = { bound, {} };
    const CertifiedCells certified = grown(data, bound);
    const CertifiedCells points(data.native, data.interfaces, bounds, 40, NativeElements::Points);
    EXPECT_GE(certified.cellCount(), points.cellCount());
    EXPECT_LT(certified.cellCount(), 2 * points.cellCount());
    // A surface: cells grow like 1 / h^2 = 1 / bound.
    EXPECT_TRUE(last == 0 || certified.cellCount() < 6 * last);
    last = certified.cellCount();
  }
}
}
}
