#include "Core/Slice/SliceSupport.h"

#include "Contour/Contour.h"
#include "Model/Errors.h"

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>

using namespace strata;
using namespace strata::test;

namespace
{
MaterialPolygons contourAll(const Mesh& mesh, double value)
{
  Progress progress;
  return contour(view(mesh), FieldId(0), { value }, allMaterials(mesh), progress);
}

/// Gives all materials the same values, so that the contours of all together are those of one function.
template<class Value>
void setEverywhere(Mesh& mesh, const Value& value)
{
  for (const MaterialId m : allMaterials(mesh))
  {
    setValues(mesh, FieldId(0), m, [&](const Vector& p, int) { return value(p); });
  }
}

void setRandomValues(Mesh& mesh, unsigned seed)
{
  std::vector<float> drawn;
  std::mt19937 random(seed);
  // Eighths, so that vertices often have the value of the contour.
  std::uniform_int_distribution<int> eighths(0, 8);
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    drawn.push_back(static_cast<float>(eighths(random)) / 8.0F);
  }
  for (const MaterialId m : allMaterials(mesh))
  {
    std::size_t next = 0;
    setValues(mesh, FieldId(0), m, [&](const Vector&, int) { return drawn[next++]; });
  }
}

/// How far a point of a tetrahedron is from the border of a material's region, as a difference of distances.
double offBorder(const Mesh& mesh, Index cell, const Vector& point, int material)
{
  const std::int64_t* corners = &mesh.tetrahedra[4 * cell];
  Eigen::Matrix4d system;
  for (int corner = 0; corner < 4; ++corner)
  {
    system.col(corner) << vertexPosition(mesh, corners[corner]), 1.0;
  }
  const Eigen::Vector4d weights = system.inverse() * Eigen::Vector4d(point[0], point[1], point[2], 1.0);
  const auto distance = [&](std::size_t m) {
    double sum = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      sum += weights[corner] * static_cast<double>(mesh.distances[m][corners[corner]]);
    }
    return sum;
  };
  double others = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < mesh.materials.size(); ++m)
  {
    others = static_cast<int>(m) == material ? others : std::min(others, distance(m));
  }
  return std::abs(others - distance(static_cast<std::size_t>(material)));
}

Mesh halves(int n, const Vector& normal)
{
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  Mesh mesh = kuhnMesh(box, n, { { "left", true }, { "right", true } }, { { "scalar", 1 } });
  setTwoMaterials(
    mesh, MaterialId(0), MaterialId(1), [&](const Vector& p) { return normal.dot(Vector(0.5, 0.5, 0.5) - p); });
  return mesh;
}
}

TEST(Contour, ALinearFieldOfAllMaterialsGivesTheSectionOfTheBox)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    // Multiples of a quarter are exact in the values' precision.
    Mesh mesh = randomRegions(4, 1 + seed % 5, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    const Vector gradient(1.0, -2.0, 3.0);
    setEverywhere(mesh, [&](const Vector& p) { return gradient.dot(p); });
    const double value = 0.7 - 0.05 * seed;
    SlicePlane plane = planeOf(Vector::Zero(), gradient);
    plane.offset = value;
    const std::vector<double> areas = areasByMaterial(contourAll(mesh, value), 5);
    EXPECT_NEAR(total(areas), sectionOfUnitCube(plane), 1e-12) << "seed " << seed;
  }
}

TEST(Contour, EachMaterialHasItsOwnPlaneClippedToItsRegion)
{
  Mesh mesh = halves(8, Vector(1.0, 0.25, 0.0));
  setValues(mesh, FieldId(0), MaterialId(0), [](const Vector& p, int) { return p[1]; });
  setValues(mesh, FieldId(0), MaterialId(1), [](const Vector& p, int) { return 2.0 - p[2]; });
  // Left, x < 1/2 - (y - 1/2) / 4: at y = 1/4 as wide as 9/16. Nothing on the right: its values are 1 and more.
  const MaterialPolygons left = contourAll(mesh, 0.25);
  EXPECT_NEAR(areasByMaterial(left, 2)[0], 9.0 / 16.0, 1e-7);
  EXPECT_EQ(areasByMaterial(left, 2)[1], 0.0);
  // Right at z = 3/4: half the section. The left has values up to 1 only.
  const MaterialPolygons right = contourAll(mesh, 1.25);
  EXPECT_EQ(areasByMaterial(right, 2)[0], 0.0);
  EXPECT_NEAR(areasByMaterial(right, 2)[1], 0.5, 1e-7);
  for (Index corner = 0; corner < left.corners.size(); ++corner)
  {
    const Vector p = pointOf(left, corner);
    EXPECT_NEAR(p[1], 0.25, 1e-7);
    EXPECT_LE(p[0], 9.0 / 16.0 + 1e-7);
  }
}

TEST(Contour, ASphereHasItsAreaUpToTheInterpolation)
{
  const int n = 32;
  Mesh mesh = halves(n, Vector(0.0, 0.0, 1.0));
  const Vector center(0.5, 0.5, 0.5);
  setEverywhere(mesh, [&](const Vector& p) { return (p - center).norm(); });
  const double radius = 0.3;
  const std::vector<double> areas = areasByMaterial(contourAll(mesh, radius), 2);
  const double half = 2.0 * 3.14159265358979323846 * radius * radius;
  // The interpolation is off by at most |e|^2 / (8 r) = 3 / (8 r n^2), to first order a relative 2 of that over r.
  const double tolerance = half * 2.0 * 3.0 / (8.0 * radius * radius * n * n);
  EXPECT_NEAR(areas[0], half, tolerance);
  EXPECT_NEAR(areas[1], half, tolerance);
}

TEST(Contour, AMaterialsContourIsClosedUpToItsBorderAndTheBox)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    Mesh mesh = randomRegions(3, 2 + seed % 4, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    setRandomValues(mesh, seed);
    for (const MaterialId m : allMaterials(mesh))
    {
      Progress progress;
      const MaterialPolygons polygons = contour(view(mesh), FieldId(0), { 0.5 }, MaterialSet::of(m), progress);
      const auto balance = edgeBalance(polygons);
      for (Index p = 0; p < polygonCount(polygons); ++p)
      {
        for (Index i = polygons.offsets[p]; i < polygons.offsets[p + 1]; ++i)
        {
          const Vector a = pointOf(polygons, i);
          const Vector b = pointOf(polygons, i + 1 < polygons.offsets[p + 1] ? i + 1 : polygons.offsets[p]);
          const bool ascending = std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
          const Vector& first = ascending ? a : b;
          const Vector& second = ascending ? b : a;
          const std::array<double, 6> edge{ first[0], first[1], first[2], second[0], second[1], second[2] };
          if (a != b && balance.at(edge) != 0 && !onOneSideOfTheCube(edge))
          {
            const Vector middle = 0.5 * (a + b);
            ASSERT_NEAR(offBorder(mesh, polygons.tetrahedron[p], middle, m.value), 0.0, 1e-12) << "seed " << seed;
          }
        }
      }
    }
  }
}

TEST(Contour, ContoursOfNeighboursMeetWithoutAGapWhereTheirFieldsAgree)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    Mesh mesh = randomRegions(3, 1 + seed % 5, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    setRandomValues(mesh, seed);
    const MaterialPolygons polygons = contourAll(mesh, seed % 3 ? 0.5 : 0.45);
    ASSERT_GT(polygonCount(polygons), 0);
    for (const auto& edge : edgeBalance(polygons))
    {
      ASSERT_TRUE(edge.second == 0 || onOneSideOfTheCube(edge.first)) << "seed " << seed;
    }
  }
}

TEST(Contour, ALayerOfVerticesThatHaveTheValueIsShownOnceAndAPlateauNot)
{
  Mesh mesh = halves(4, Vector(1.0, 0.0, 0.0));
  setEverywhere(mesh, [](const Vector& p) { return p[2]; });
  EXPECT_NEAR(total(areasByMaterial(contourAll(mesh, 0.5), 2)), 1.0, 1e-14);
  EXPECT_NEAR(total(areasByMaterial(contourAll(mesh, 1.0), 2)), 1.0, 1e-14);
  setEverywhere(mesh, [](const Vector&) { return 0.5; });
  EXPECT_EQ(polygonCount(contourAll(mesh, 0.5)), 0);
}

TEST(Contour, PolygonsFaceLargerValuesAndCarryTheFields)
{
  const Mesh mesh = randomRegions(3, 4, RandomDistances::Reals, 4);
  const double value = 11.0; // 10 m + x - 2 y + 3 z of the second material
  const MaterialPolygons polygons = contourAll(mesh, value);
  ASSERT_GT(polygonCount(polygons), 0);
  for (Index p = 0; p < polygonCount(polygons); ++p)
  {
    EXPECT_GE(areaOf(polygons, p).dot(Vector(1.0, -2.0, 3.0)), 0.0);
    for (Index i = polygons.offsets[p]; i < polygons.offsets[p + 1]; ++i)
    {
      const Vector at = pointOf(polygons, i);
      EXPECT_NEAR(polygons.values[0][polygons.corners[i]], value, 1e-5);
      EXPECT_NEAR(polygons.values[1][3 * polygons.corners[i]], at[0] - polygons.material[p], 1e-6);
    }
  }
}

TEST(Contour, AMaterialThatLacksTheFieldOrACellsValuesGivesNothing)
{
  Mesh mesh = halves(4, Vector(1.0, 0.0, 0.0));
  setEverywhere(mesh, [](const Vector& p) { return p[2]; });
  mesh.values[0][1] = Buffer<float>();
  EXPECT_EQ(areasByMaterial(contourAll(mesh, 0.3), 2)[1], 0.0);
  // No value on the far side of the border, as where no cell needs one: the left loses nothing.
  Buffer<float>& left = mesh.values[0][0];
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    if (vertexPosition(mesh, vertex)[0] > 0.75)
    {
      left[vertex] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  EXPECT_NEAR(areasByMaterial(contourAll(mesh, 0.3), 2)[0], 0.5, 1e-7);
}

TEST(Contour, SeveralValuesGiveWhatEachGivesAlone)
{
  const Mesh mesh = randomRegions(4, 3, RandomDistances::Reals, 2);
  Progress progress;
  const std::vector<double> values{ 0.25, 0.75, 10.5 };
  const MaterialPolygons together = contour(view(mesh), FieldId(0), values, allMaterials(mesh), progress);
  Index points = 0;
  double area = 0.0;
  for (const double value : values)
  {
    const MaterialPolygons alone = contourAll(mesh, value);
    points += alone.points.size();
    area += total(areasByMaterial(alone, 3));
  }
  EXPECT_EQ(together.points.size(), points);
  EXPECT_NEAR(total(areasByMaterial(together, 3)), area, 1e-12);
}

TEST(Contour, TheNumberOfThreadsChangesNoByte)
{
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    Mesh mesh = randomRegions(8, 4, seed % 2 ? RandomDistances::Ties : RandomDistances::Reals, seed);
    setRandomValues(mesh, seed);
    const MaterialPolygons two = contourAll(mesh, 0.5);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    expectSameBytes(two, contourAll(mesh, 0.5));
  }
}

TEST(Contour, VectorsUnknownFieldsAndValuesThatAreNoNumbersAreRefused)
{
  const Mesh mesh = randomRegions(2, 2, RandomDistances::Reals, 1);
  Progress progress;
  EXPECT_THROW(contour(view(mesh), FieldId(1), { 0.5 }, allMaterials(mesh), progress), InvalidInput);
  EXPECT_THROW(contour(view(mesh), FieldId(2), { 0.5 }, allMaterials(mesh), progress), InvalidInput);
  EXPECT_THROW(contourAll(mesh, std::numeric_limits<double>::quiet_NaN()), InvalidInput);
}
