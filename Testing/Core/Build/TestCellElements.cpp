#include "Build/CellElements.h"
#include "Build/CellErrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace strata
{
namespace
{
const std::array<Vector, 4> corners = { Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1) };

/// Whether any of many points of the triangle lies in the reference tetrahedron.
bool meetsBySampling(const std::array<Vector, 3>& t)
{
  constexpr int n = 60;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; i + j <= n; ++j)
    {
      const Vector p = (t[0] * i + t[1] * j + t[2] * (n - i - j)) / n;
      if (p.minCoeff() >= 0.0 && p.sum() <= 1.0)
      {
        return true;
      }
    }
  }
  return false;
}

TEST(CellElements, ATriangleThatReachesIntoACellMeetsIt)
{
  const Barycentric cell(corners);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1.0, 2.0);
  int met = 0;
  int missed = 0;
  for (int trial = 0; trial < 5000; ++trial)
  {
    std::array<Vector, 3> t;
    for (Vector& p : t)
    {
      p = Vector(coordinate(random), coordinate(random), coordinate(random));
    }
    const bool sampled = meetsBySampling(t);
    met += sampled ? 1 : 0;
    if (sampled)
    {
      EXPECT_TRUE(meets(cell, t));
    }
    else
    {
      missed += meets(cell, t) ? 0 : 1;
    }
  }
  EXPECT_GT(met, 200);
  // Sampling overlooks slight contacts only.
  EXPECT_GT(missed, 0.9 * (5000 - met));
}

TEST(CellElements, ATriangleAcrossACellWithoutACornerInItMeetsIt)
{
  const Barycentric cell(corners);
  EXPECT_TRUE(meets(cell, { Vector(-5, -5, 0.3), Vector(5, -5, 0.3), Vector(0, 9, 0.3) }));
  EXPECT_FALSE(meets(cell, { Vector(-5, -5, 1.3), Vector(5, -5, 1.3), Vector(0, 9, 1.3) }));
}

TEST(CellElements, ATriangleInAFaceMeetsTheCell)
{
  const Barycentric cell(corners);
  EXPECT_TRUE(meets(cell, { Vector(0.1, 0.1, 0), Vector(0.2, 0.1, 0), Vector(0.1, 0.2, 0) }));
}

TEST(CellErrors, StoredErrorsAreNeverBelowTheTrueOnes)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(-30.0, 30.0);
  for (int trial = 0; trial < 10000; ++trial)
  {
    const double value = std::exp(exponent(random));
    const float stored = roundedUp(value);
    EXPECT_GE(static_cast<double>(stored), value);
    EXPECT_LT(static_cast<double>(std::nextafter(stored, 0.0f)), value);
  }
  EXPECT_EQ(0.0f, roundedUp(0.0));
  EXPECT_TRUE(std::isinf(roundedUp(std::numeric_limits<double>::infinity())));
}
}
}
