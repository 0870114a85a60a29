#include "Conversion/OrientSurface.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace
{
using strata::Index;
using strata::Vector;
using strata::conversion::SurfaceTriangle;

/// A sheet of n x n squares that looks up, whose middle point leans so far that triangles hang over.
struct LeaningSheet
{
  std::vector<Vector> points;
  std::vector<SurfaceTriangle> triangles;
  vtkNew<vtkPolyData> surface;

  LeaningSheet()
  {
    constexpr Index n = 4;
    for (Index j = 0; j <= n; ++j)
    {
      for (Index i = 0; i <= n; ++i)
      {
        points.emplace_back(static_cast<double>(i), static_cast<double>(j), 0.0);
      }
    }
    points[12] += Vector(1.8, 0.0, 0.4);
    for (Index j = 0; j < n; ++j)
    {
      for (Index i = 0; i < n; ++i)
      {
        const Index p = i + (n + 1) * j;
        triangles.push_back({ p, p + 1, p + n + 2 });
        triangles.push_back({ p, p + n + 2, p + n + 1 });
      }
    }
    giveNormals(1.0);
  }

  Vector areaOf(const SurfaceTriangle& t) const
  {
    const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
    return (at(1) - at(0)).cross(at(2) - at(0));
  }

  /// Point normals as the mean of the triangles around, times a sign.
  void giveNormals(double sign)
  {
    std::vector<Vector> sums(points.size(), Vector::Zero());
    for (const SurfaceTriangle& t : triangles)
    {
      for (const Index corner : t)
      {
        sums[static_cast<std::size_t>(corner)] += areaOf(t);
      }
    }
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    for (const Vector& sum : sums)
    {
      const Vector normal = sign * sum.normalized();
      normals->InsertNextTuple3(normal.x(), normal.y(), normal.z());
    }
    surface->GetPointData()->SetNormals(normals);
  }
};

TEST(OrientSurface, TrianglesThatHangOverKeepTheWindingOfTheirSurface)
{
  LeaningSheet sheet;
  // The sheet does have a triangle that looks down while its points' normals look up.
  EXPECT_TRUE(std::any_of(sheet.triangles.begin(), sheet.triangles.end(),
    [&](const SurfaceTriangle& t) { return sheet.areaOf(t).z() < 0.0; }));
  std::vector<SurfaceTriangle> turned = sheet.triangles;
  strata::conversion::orient(sheet.surface, sheet.points, turned);
  EXPECT_EQ(turned, sheet.triangles);
}

TEST(OrientSurface, ASurfaceWhoseNormalsPointTheOtherWayTurnsAsAWhole)
{
  LeaningSheet sheet;
  sheet.giveNormals(-1.0);
  std::vector<SurfaceTriangle> turned = sheet.triangles;
  strata::conversion::orient(sheet.surface, sheet.points, turned);
  for (std::size_t t = 0; t < turned.size(); ++t)
  {
    EXPECT_EQ(turned[t], (SurfaceTriangle{ sheet.triangles[t][0], sheet.triangles[t][2], sheet.triangles[t][1] }));
  }
}

TEST(OrientSurface, ATriangleWoundAgainstItsNeighboursTurnsAlone)
{
  LeaningSheet sheet;
  std::vector<SurfaceTriangle> turned = sheet.triangles;
  std::swap(turned[3][1], turned[3][2]);
  strata::conversion::orient(sheet.surface, sheet.points, turned);
  EXPECT_EQ(turned, sheet.triangles);
}
}
