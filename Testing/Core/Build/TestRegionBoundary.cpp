#include "Build/RegionBoundary.h"

#include "Support/SphereCase.h"
#include "Support/TriangulatedShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

namespace strata
{
namespace
{
using namespace test;

Box unitBox()
{
  Box box;
  box.add(Vector::Zero());
  box.add(Vector::Ones());
  return box;
}

std::vector<Vector> randomPoints(int count)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vector> points;
  for (int i = 0; i < count; ++i)
  {
    points.emplace_back(unit(random), unit(random), unit(random));
  }
  return points;
}

TEST(RegionBoundary, DistancesToABallAreThoseToItsTriangles)
{
  const Vector center(0.5, 0.5, 0.5);
  const Interfaces interfaces = interfaceBetween(sphereSurface(center, 0.3, 4), MaterialId(1), MaterialId(0));
  const RegionBoundary ball(interfaces, MaterialId(0), unitBox(), DistanceMethod::ClosestPoint, false);
  const RegionBoundary rest(interfaces, MaterialId(1), unitBox(), DistanceMethod::ClosestPoint, false);
  // Edges of a 4 times split icosahedron are 1/16 rad long: chords lie r (1 - cos(1/32)) = 0.0002 inside.
  const double tolerance = 0.0005;
  for (const Vector& p : randomPoints(2000))
  {
    const double d = (p - center).norm() - 0.3;
    const RegionPoint inBall = ball.locate(p);
    const RegionPoint inRest = rest.locate(p);
    EXPECT_NEAR(std::max(d, 0.0), inBall.distance, tolerance);
    EXPECT_NEAR(std::max(-d, 0.0), inRest.distance, tolerance);
    if (std::abs(d) > tolerance)
    {
      EXPECT_EQ(d < 0.0, inBall.inside);
      EXPECT_EQ(d > 0.0, inRest.inside);
    }
    EXPECT_NEAR(inBall.distance, (inBall.closest - p).norm(), 1e-14);
  }
}

TEST(RegionBoundary, SurfacesThatEndAtTheWallsOfTheBoxSeparateItsInside)
{
  std::mt19937 random(5);
  std::normal_distribution<double> direction;
  for (int trial = 0; trial < 50; ++trial)
  {
    // A plane through the box, cut to it: the fan about its centre has borders only on the walls.
    const Vector normal = Vector(direction(random), direction(random), direction(random)).normalized();
    const Vector through(0.4, 0.5, 0.6);
    std::vector<Vector> corners;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int edge = 0; edge < 4; ++edge)
      {
        Vector a;
        a[axis] = 0.0;
        a[(axis + 1) % 3] = edge & 1;
        a[(axis + 2) % 3] = edge >> 1;
        const double t = normal.dot(through - a) / normal[axis];
        if (t >= 0.0 && t <= 1.0)
        {
          a[axis] = t;
          corners.push_back(a);
        }
      }
    }
    const Vector u = normal.unitOrthogonal();
    const Vector v = normal.cross(u);
    std::sort(corners.begin(), corners.end(), [&](const Vector& a, const Vector& b) {
      return std::atan2(v.dot(a - through), u.dot(a - through)) < std::atan2(v.dot(b - through), u.dot(b - through));
    });
    Triangles triangles;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      triangles.push_back({ through, corners[i], corners[(i + 1) % corners.size()] });
    }
    const Interfaces plane = interfaceBetween(triangles, MaterialId(0), MaterialId(1));
    const RegionBoundary above(plane, MaterialId(0), unitBox(), DistanceMethod::ClosestPoint, false);
    for (const Vector& p : randomPoints(200))
    {
      const double height = normal.dot(p - through);
      if (std::abs(height) > 1e-9)
      {
        EXPECT_EQ(height > 0.0, above.locate(p).inside) << "trial " << trial << ", height " << height;
      }
    }
  }
}

/// Triangles of a surface that keep to a condition on their corners' mean.
template<typename Keep>
Triangles kept(const Triangles& triangles, const Keep& keep)
{
  Triangles result;
  std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(result),
    [&](const auto& t) { return keep(Vector((t[0] + t[1] + t[2]) / 3.0)); });
  return result;
}

TEST(RegionBoundary, AHoleInASphereDoesNotTurnSidesRoundIt)
{
  const Vector center(0.5, 0.5, 0.5);
  // The polar cap above a chord of half the radius' height is missing: a hole 0.5 wide in a sphere 0.6 wide.
  const double chord = 0.5 * std::sqrt(3.0) * 0.5 + 0.01;
  const Triangles open =
    kept(sphereSurface(center, 0.3, 4), [&](const Vector& p) { return p.z() - 0.5 < 0.3 * chord; });
  const Interfaces interfaces = interfaceBetween(open, MaterialId(1), MaterialId(0));
  const RegionBoundary ball(interfaces, MaterialId(0), unitBox(), DistanceMethod::ClosestPoint, false);
  const RegionBoundary rest(interfaces, MaterialId(1), unitBox(), DistanceMethod::ClosestPoint, false);
  for (const Vector& p : randomPoints(4000))
  {
    const double d = (p - center).norm() - 0.3;
    // Over the hole, nothing says where between a flat lid and one as high as wide the border is.
    const double overHole = p.z() - 0.5 - 0.3 * chord;
    const bool open_ = std::hypot(p.x() - 0.5, p.y() - 0.5) < 0.3 && overHole > -0.1 && overHole < 0.3;
    if (std::abs(d) > 0.001 && !open_)
    {
      EXPECT_EQ(d < 0.0, ball.locate(p).inside) << p.transpose();
      EXPECT_EQ(d > 0.0, rest.locate(p).inside) << p.transpose();
    }
  }
}

TEST(RegionBoundary, ASheetThatEndsBeforeTheWallsIsContinued)
{
  const Triangles sheet = parallelogram(Vector(0.1, 0.1, 0.45), Vector(0.8, 0, 0), Vector(0, 0.8, 0), 8);
  const Interfaces interfaces = interfaceBetween(sheet, MaterialId(0), MaterialId(1));
  const RegionBoundary above(interfaces, MaterialId(0), unitBox(), DistanceMethod::ClosestPoint, false);
  const RegionBoundary below(interfaces, MaterialId(1), unitBox(), DistanceMethod::ClosestPoint, false);
  for (const Vector& p : randomPoints(2000))
  {
    // The walls are known by squares of 1/32, the winding number to 0.002.
    if (std::abs(p.z() - 0.45) > 0.05)
    {
      EXPECT_EQ(p.z() > 0.45, above.locate(p).inside) << p.transpose();
      EXPECT_EQ(p.z() < 0.45, below.locate(p).inside) << p.transpose();
    }
  }
}

TEST(SurfaceEdges, OnlyBordersWithinTheBoxAreOpen)
{
  const Vector center(0.5, 0.5, 0.5);
  const auto borders = [&](const Triangles& triangles) {
    return openBorders(interfaceBetween(triangles, MaterialId(1), MaterialId(0)), 2, unitBox());
  };
  EXPECT_TRUE(borders(sphereSurface(center, 0.3, 2)).empty());
  EXPECT_TRUE(borders(parallelogram(Vector(-0.1, 0, 0.4), Vector(1.2, 0, 0), Vector(0, 1, 0), 4)).empty());
  Triangles open = sphereSurface(center, 0.3, 2);
  open.pop_back();
  const std::vector<OpenBorder> hole = borders(open);
  ASSERT_EQ(hole.size(), 2u) << "both materials";
  EXPECT_EQ(hole.front().edges, 3);
  EXPECT_LT(hole.front().reach, 0.3) << "half the size of a triangle at most";
  // A sheet 0.05 short of the walls may be wrong that far from its edges.
  const std::vector<OpenBorder> sheet =
    borders(parallelogram(Vector(0.05, 0.05, 0.5), Vector(0.9, 0, 0), Vector(0, 0.9, 0), 6));
  ASSERT_EQ(sheet.size(), 2u);
  EXPECT_EQ(sheet.front().edges, 24);
  EXPECT_NEAR(sheet.front().length, 3.6, 1e-12);
  EXPECT_NEAR(sheet.front().reach, 0.05, 1e-12);
}

TEST(RegionBoundary, ThePapersDistanceIsToTheClosestVertex)
{
  const Interfaces interfaces =
    interfaceBetween(sphereSurface(Vector(0.5, 0.5, 0.5), 0.3, 2), MaterialId(1), MaterialId(0));
  const RegionBoundary ball(interfaces, MaterialId(0), unitBox(), DistanceMethod::ClosestVertex, false);
  for (const Vector& p : randomPoints(300))
  {
    double nearest = 1e30;
    for (const Vector& vertex : interfaces.points)
    {
      nearest = std::min(nearest, (p - vertex).norm());
    }
    const RegionPoint found = ball.locate(p);
    EXPECT_NEAR(found.inside ? 0.0 : nearest, found.distance, 1e-14);
  }
}

TEST(RegionBoundary, WithoutInterfacesARegionIsAllOrNothing)
{
  const Interfaces none;
  const RegionBoundary all(none, MaterialId(0), unitBox(), DistanceMethod::ClosestPoint, true);
  const RegionBoundary nothing(none, MaterialId(1), unitBox(), DistanceMethod::ClosestPoint, false);
  EXPECT_EQ(0.0, all.locate(Vector(0.1, 0.2, 0.3)).distance);
  EXPECT_TRUE(all.locate(Vector(0.1, 0.2, 0.3)).inside);
  EXPECT_GE(nothing.locate(Vector(0.1, 0.2, 0.3)).distance, std::sqrt(3.0));
}
}
}
