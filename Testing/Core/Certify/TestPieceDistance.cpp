#include "Certify/PieceDistance.h"

#include "Support/TriangulatedShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace strata
{
namespace
{
using namespace test;

constexpr double rounding = 1e-14;
const UnorderedPair pair = UnorderedPair::of(MaterialId(0), MaterialId(1));

std::vector<InterfacePiece> piecesOf(const Triangles& triangles)
{
  std::vector<InterfacePiece> pieces;
  for (const auto& [a, b, c] : triangles)
  {
    pieces.push_back({ pair, { a, b, c } });
  }
  return pieces;
}

InterfaceTrees treesOf(const Triangles& triangles)
{
  const std::vector<InterfacePiece> pieces = piecesOf(triangles);
  return InterfaceTrees({ &pieces });
}

/// By brute force, at random points of the pieces.
double seenDistance(const Triangles& from, const Triangles& to, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double largest2 = 0.0;
  for (int i = 0; i < 10000; ++i)
  {
    const auto& [a, b, c] = from[static_cast<std::size_t>(i) % from.size()];
    const double s = std::sqrt(unit(random));
    const double t = unit(random);
    const Vector p = (1.0 - s) * a + s * (1.0 - t) * b + s * t * c;
    double smallest2 = std::numeric_limits<double>::infinity();
    for (const auto& triangle : to)
    {
      smallest2 = std::min(smallest2, (closestPointOnTriangle(p, triangle).point - p).squaredNorm());
    }
    largest2 = std::max(largest2, smallest2);
  }
  return std::sqrt(largest2);
}

TEST(PieceDistance, ManyPiecesDoNotLetTheBoundDriftAwayFromTheTruth)
{
  // All lie in the surface, each reaching a little farther over the line between two of its triangles than the last.
  const Triangles surface = parallelogram(Vector(-1, -1, 0), Vector(2, 0, 0), Vector(0, 2, 0), 1);
  Triangles pieces;
  for (int i = 1; i <= 20; ++i)
  {
    const double reach = 0.009 * i;
    pieces.push_back({ Vector(-0.3, 0.3, 0), Vector(-0.2, 0.4, 0), Vector(0.5 * reach, -0.5 * reach, 0) });
  }
  const double limit = 0.1;
  EXPECT_LE(largestDistance(piecesOf(pieces), treesOf(surface), limit, rounding), 0.25 * limit + 2.0 * rounding);
}

TEST(PieceDistance, NoPointIsFartherAndTheBoundIsSmallOrWithinATenthOfTheLimitOfSomePoint)
{
  std::mt19937 random(1);
  for (const double radius : { 0.8, 0.9, 0.97 })
  {
    const Triangles inner = sphereSurface(Vector::Zero(), radius, 1);
    const Triangles outer = sphereSurface(Vector::Zero(), 1.0, 2);
    const double limit = 0.3;
    const double bound = largestDistance(piecesOf(inner), treesOf(outer), limit, rounding);
    const double seen = seenDistance(inner, outer, random);
    EXPECT_GE(bound, seen);
    // 125 points on a triangle of edge 0.6: one of them is about as far as the farthest point.
    EXPECT_LE(bound, std::max(0.25 * limit, seen + 0.1 * limit + 0.01));
  }
}

TEST(PieceDistance, BeyondTheLimitItIsTheDistanceOfAPoint)
{
  const Triangles lower = parallelogram(Vector(0, 0, 0), Vector::UnitX(), Vector::UnitY(), 2);
  const Triangles upper = parallelogram(Vector(0, 0, 0.5), Vector::UnitX(), Vector::UnitY(), 3);
  EXPECT_NEAR(0.5, largestDistance(piecesOf(upper), treesOf(lower), 0.1, rounding), 1e-12);
}

TEST(PieceDistance, WithoutASurfaceBetweenItsMaterialsAPieceIsInfinitelyFar)
{
  const Triangles square = parallelogram(Vector(0, 0, 0), Vector::UnitX(), Vector::UnitY(), 1);
  std::vector<InterfacePiece> pieces = piecesOf(square);
  pieces.back().materials = UnorderedPair::of(MaterialId(0), MaterialId(2));
  EXPECT_EQ(std::numeric_limits<double>::infinity(), largestDistance(pieces, treesOf(square), 0.1, rounding));
  EXPECT_EQ(0.0, largestDistance({}, treesOf(square), 0.1, rounding));
}
}
}
