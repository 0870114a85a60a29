#include "Build/BoxCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace strata
{
namespace
{
double coordinate(std::mt19937& random, double lower = -1.0, double upper = 1.0)
{
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

Vector randomVector(std::mt19937& random, double lower = -1.0, double upper = 1.0)
{
  const double x = coordinate(random, lower, upper);
  const double y = coordinate(random, lower, upper);
  return { x, y, coordinate(random, lower, upper) };
}

MultilinearFunction randomFunction(std::mt19937& random)
{
  std::array<double, 8> values;
  for (double& value : values)
  {
    value = coordinate(random);
  }
  return MultilinearFunction(values);
}

/// A descendant of a Kuhn tetrahedron of a box by Maubach's bisection.
std::array<Vector, 4> bisected(std::mt19937& random, const Vector& size, int bisections)
{
  std::array<int, 3> path = { 0, 1, 2 };
  std::shuffle(path.begin(), path.end(), random);
  std::array<Vector, 4> x;
  x[0] = Vector::Zero();
  for (std::size_t i = 0; i < 3; ++i)
  {
    x[i + 1] = x[i] + size[path[i]] * Vector::Unit(path[i]);
  }
  std::size_t tag = 3;
  for (int i = 0; i < bisections; ++i)
  {
    const Vector middle = 0.5 * (x[0] + x[tag]);
    if (random() % 2 == 0)
    {
      std::copy(x.begin() + 1, x.begin() + 1 + static_cast<std::ptrdiff_t>(tag), x.begin());
    }
    x[tag] = middle;
    tag = tag == 1 ? 3 : tag - 1;
  }
  return x;
}

TEST(MultilinearFunction, TakesItsValuesAtTheCornersAndIsLinearBetween)
{
  const MultilinearFunction f({ 1, 2, 3, 5, 7, 11, 13, 17 });
  EXPECT_EQ(1.0, f(Vector(0, 0, 0)));
  EXPECT_EQ(2.0, f(Vector(1, 0, 0)));
  EXPECT_EQ(3.0, f(Vector(0, 1, 0)));
  EXPECT_EQ(13.0, f(Vector(0, 1, 1)));
  EXPECT_EQ(17.0, f(Vector(1, 1, 1)));
  // (3 + 5) / 2 below, (13 + 17) / 2 above.
  EXPECT_DOUBLE_EQ(0.25 * 4.0 + 0.75 * 15.0, f(Vector(0.5, 1, 0.75)));
}

TEST(MultilinearFunction, ItsLargestValueOnASegmentIsThatOfDenseSampling)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const MultilinearFunction f = randomFunction(random);
    const Vector a = randomVector(random);
    // Along axes and diagonals the polynomial has a lower degree.
    const Vector step = trial % 3 == 0 ? Vector(1.0, trial % 2, 0.0) : randomVector(random);
    double sampled = 0.0;
    for (int i = 0; i <= 1000; ++i)
    {
      sampled = std::max(sampled, std::abs(f(a + step * (i / 1000.0))));
    }
    const double largest = f.along(a, a + step).largestAbsoluteValue();
    EXPECT_GE(largest, sampled - 1e-13);
    EXPECT_LE(largest, sampled + 1e-4);
    EXPECT_GE(f.along(a, a + step).quickBound(), largest - 1e-13);
  }
}

TEST(BoxCut, TheEdgesHoldTheLargestValueOfTheIntersection)
{
  std::mt19937 random(2);
  int cuts = 0;
  for (int trial = 0; trial < 600; ++trial)
  {
    const Vector size = randomVector(random, 0.5, 2.0);
    const std::array<Vector, 4> corners = bisected(random, size, static_cast<int>(random() % 9));
    const Barycentric barycentric(corners);
    Box box;
    box.lower = randomVector(random, -0.3, 0.6);
    // Every other box is the lattice's own, whose faces the tetrahedra share.
    box.lower =
      trial % 2 == 0 ? Vector((4.0 * box.lower).array().round().matrix().cwiseProduct(size) / 4.0) : box.lower;
    box.upper =
      box.lower + size.cwiseProduct(trial % 2 == 0 ? Vector(0.25, 0.25, 0.5) : randomVector(random, 0.1, 0.9));
    BoxCut cut(corners, barycentric, box);
    const MultilinearFunction f = randomFunction(random);
    double bound = 0.0;
    if (!cut.empty())
    {
      for (const BoxCut::Edge& edge : cut)
      {
        bound = std::max(bound, f.along(edge.a, edge.b).largestAbsoluteValue());
      }
    }
    double sampled = 0.0;
    int inside = 0;
    for (int i = 0; i < 4000; ++i)
    {
      std::array<double, 4> weights;
      double sum = 0.0;
      for (double& weight : weights)
      {
        // Many samples on faces and edges, where the maximum is.
        weight = random() % 3 == 0 ? 0.0 : -std::log(coordinate(random, 1e-12, 1.0));
        sum += weight;
      }
      if (sum == 0.0)
      {
        continue;
      }
      const Vector p =
        (weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] + weights[3] * corners[3]) / sum;
      if (box.contains(p))
      {
        ++inside;
        sampled = std::max(sampled, std::abs(f((p - box.lower).cwiseQuotient(box.size()))));
      }
    }
    EXPECT_GE(bound, sampled - 1e-9);
    if (inside > 1000)
    {
      EXPECT_LE(bound, 1.25 * sampled) << "trial " << trial;
      ++cuts;
    }
  }
  EXPECT_GT(cuts, 20);
}

TEST(BoxCut, ABoxAwayFromTheTetrahedronHasNoEdgesInIt)
{
  const std::array<Vector, 4> corners = { Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(1, 1, 1) };
  const Barycentric barycentric(corners);
  Box beside;
  beside.lower = Vector(2, 0, 0);
  beside.upper = Vector(3, 1, 1);
  EXPECT_TRUE(BoxCut(corners, barycentric, beside).empty());
  Box atCorner;
  atCorner.lower = Vector(0, 0.5, 0.5);
  atCorner.upper = Vector(0.4, 1, 1);
  BoxCut none(corners, barycentric, atCorner);
  EXPECT_EQ(none.begin(), none.end());
}
}
}
