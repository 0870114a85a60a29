#include "Geometry/WindingNumber.h"

#include "Support/TriangulatedShapes.h"

#include <gtest/gtest.h>

#include <random>

namespace strata
{
namespace
{
using namespace test;

TEST(WindingNumber, OfAClosedSurfaceIsOneInsideAndZeroOutside)
{
  const WindingNumber sphere(sphereSurface(Vector::Zero(), 1.0, 4));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector p(place(random), place(random), place(random));
    if (std::abs(p.norm() - 1.0) > 0.01)
    {
      EXPECT_NEAR(sphere.at(p), p.norm() < 1.0 ? 1.0 : 0.0, 0.02) << p.transpose();
    }
  }
}

TEST(WindingNumber, OfAPartIsThePartOfAllDirectionsThatItTakesUp)
{
  // Seen from its middle each side of a cube is a sixth of everything.
  const WindingNumber side(parallelogram(Vector(1, -1, -1), Vector(0, 2, 0), Vector(0, 0, 2), 16));
  EXPECT_NEAR(side.at(Vector::Zero()), 1.0 / 6.0, 0.002);
  EXPECT_NEAR(side.at(Vector(2, 0, 0)), -1.0 / 6.0, 0.002);
}

TEST(WindingNumber, ATriangleTooManyCountsAgainstTheHalfOnly)
{
  Triangles sphere = sphereSurface(Vector::Zero(), 1.0, 2);
  sphere.push_back(sphere.front());
  const WindingNumber doubled(sphere);
  const Vector middle = (sphere.front()[0] + sphere.front()[1] + sphere.front()[2]) / 3.0;
  EXPECT_GT(doubled.at(0.98 * middle), 0.98);
  EXPECT_LT(doubled.at(1.02 * middle), 0.02);
}

TEST(WindingNumber, WaysThroughASphereCrossItOutwardsAsOftenAsInwards)
{
  const WindingNumber sphere(sphereSurface(Vector::Zero(), 1.0, 3));
  EXPECT_EQ(sphere.crossings(Vector(0.1, 0.2, 0.3), Vector(2.0, 0.4, 0.7)), 1);
  EXPECT_EQ(sphere.crossings(Vector(2.0, 0.4, 0.7), Vector(0.1, 0.2, 0.3)), -1);
  EXPECT_EQ(sphere.crossings(Vector(-2.0, 0.1, 0.2), Vector(2.0, 0.3, 0.1)), 0);
  EXPECT_EQ(sphere.crossings(Vector(0.1, 0.0, 0.0), Vector(0.0, 0.2, 0.3)), 0);
}
}
}
