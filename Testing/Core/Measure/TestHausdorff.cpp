#include "Geometry/ClosestPoint.h"
#include "Measure/DirectedDistance.h"
#include "Measure/Measure.h"
#include "Model/Errors.h"
#include "Support/TriangulatedShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <random>

using namespace strata;
using namespace strata::test;

namespace
{
HausdorffDistance distance(const Triangles& original, const Triangles& represented, double tolerance)
{
  Progress progress;
  return hausdorffDistance({ original }, { represented }, tolerance, progress);
}

void expectWithin(const DistanceInterval& interval, double truth, double tolerance)
{
  EXPECT_LE(interval.lower, truth + 1e-12);
  EXPECT_GE(interval.upper, truth - 1e-12);
  EXPECT_LE(interval.upper - interval.lower, tolerance + 1e-12);
}

Triangles randomSoup(std::mt19937_64& random, int count, double size)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Triangles soup;
  for (int i = 0; i < count; ++i)
  {
    const Vector at(unit(random), unit(random), unit(random));
    std::array<Vector, 3> triangle;
    for (Vector& corner : triangle)
    {
      corner = at + size * Vector(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
    }
    soup.push_back(triangle);
  }
  return soup;
}

Vector randomPoint(std::mt19937_64& random, const std::array<Vector, 3>& triangle)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double s = std::sqrt(unit(random));
  const double t = unit(random);
  return (1.0 - s) * triangle[0] + s * (1.0 - t) * triangle[1] + s * t * triangle[2];
}

/// The largest of the distances from random points of one surface to the other, by brute force.
double sampledDistance(std::mt19937_64& random, const Triangles& from, const Triangles& to, int points)
{
  double largest = 0.0;
  for (int i = 0; i < points; ++i)
  {
    const Vector p = randomPoint(random, from[i % from.size()]);
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& triangle : to)
    {
      smallest = std::min(smallest, (closestPointOnTriangle(p, triangle).point - p).squaredNorm());
    }
    largest = std::max(largest, smallest);
  }
  return std::sqrt(largest);
}
}

TEST(Hausdorff, ParallelSquaresAreTheirOffsetApart)
{
  const Triangles lower = parallelogram({ 0, 0, 0 }, Vector::UnitX(), Vector::UnitY(), 3);
  const Triangles upper = parallelogram({ 0, 0, 0.25 }, Vector::UnitX(), Vector::UnitY(), 7);
  const HausdorffDistance found = distance(lower, upper, 1e-3);
  expectWithin(found.originalToRepresented, 0.25, 1e-3);
  expectWithin(found.representedToOriginal, 0.25, 1e-3);
}

TEST(Hausdorff, TwoTriangulationsOfOneSquareCoincide)
{
  const Triangles coarse = parallelogram({ 0, 0, 0 }, Vector::UnitX(), Vector::UnitY(), 1);
  const Triangles fine = parallelogram({ 0, 0, 0 }, Vector::UnitX(), Vector::UnitY(), 17);
  const HausdorffDistance found = distance(coarse, fine, 5e-3);
  expectWithin(found.originalToRepresented, 0.0, 5e-3);
  expectWithin(found.representedToOriginal, 0.0, 5e-3);
}

TEST(Hausdorff, AMissingPieceIsSeenFromOneSideOnly)
{
  // Half of the square is missing: its far edge is 0.5 away from what is left.
  const Triangles whole = parallelogram({ 0, 0, 0 }, Vector::UnitX(), Vector::UnitY(), 4);
  const Triangles half = parallelogram({ 0, 0, 0 }, 0.5 * Vector::UnitX(), Vector::UnitY(), 4);
  const HausdorffDistance found = distance(whole, half, 1e-3);
  expectWithin(found.originalToRepresented, 0.5, 1e-3);
  expectWithin(found.representedToOriginal, 0.0, 1e-3);
}

TEST(Hausdorff, CubesShiftedAlongAnAxisAreTheShiftApart)
{
  // A point in the middle of the trailing face has the other cube's trailing face, `shift` away, as its closest.
  const double shift = 0.2;
  const HausdorffDistance found = distance(cubeSurface({ 0, 0, 0 }, 3), cubeSurface({ shift, 0, 0 }, 5), 1e-3);
  expectWithin(found.originalToRepresented, shift, 1e-3);
  expectWithin(found.representedToOriginal, shift, 1e-3);
}

TEST(Hausdorff, ConcentricIcosahedraDifferByRadiusOutsideAndByInradiusInside)
{
  // From the outer one: convex distance, largest at a vertex, whose closest point is the inner vertex. From the inner
  // one: every point of a face is (R - r) times the inradius away from the outer face parallel to it.
  const double inradius = std::sqrt((5.0 + 2.0 * std::sqrt(5.0)) / 15.0);
  const HausdorffDistance found =
    distance(sphereSurface({ 1, 2, 3 }, 1.5, 0), sphereSurface({ 1, 2, 3 }, 1.0, 0), 1e-4);
  expectWithin(found.originalToRepresented, 0.5, 1e-4);
  expectWithin(found.representedToOriginal, 0.5 * inradius, 1e-4);
}

TEST(Hausdorff, ConcentricSpheresDifferByTheirRadiiOutsideAndByTheirFarthestFacesInside)
{
  // Outside as above. Inside, the face farthest from the center decides: no point of the inner sphere is farther from
  // the outer one than (R - r) times the distance of its face from the center, and the face's foot point is as far
  // unless another face's plane is closer.
  const double inner = 0.9;
  const Triangles unit = sphereSurface(Vector::Zero(), 1.0, 3);
  double largest = 0.0;
  Vector foot = Vector::Zero();
  for (const auto& [a, b, c] : unit)
  {
    const Vector normal = (b - a).cross(c - a).normalized();
    if (a.dot(normal) > largest)
    {
      largest = a.dot(normal);
      foot = inner * largest * normal;
    }
  }
  for (const auto& [a, b, c] : unit)
  {
    const Vector normal = (b - a).cross(c - a).normalized();
    ASSERT_GE(a.dot(normal) - foot.dot(normal), (1.0 - inner) * largest - 1e-12);
  }
  const HausdorffDistance found = distance(unit, sphereSurface(Vector::Zero(), inner, 3), 1e-4);
  expectWithin(found.originalToRepresented, 1.0 - inner, 1e-4);
  expectWithin(found.representedToOriginal, (1.0 - inner) * largest, 1e-4);
}

TEST(Hausdorff, AMissingDropletIsAsFarAsItsFarthestVertexFromWhatIsLeft)
{
  Triangles withDroplet = parallelogram({ 0, 0, 0 }, 4.0 * Vector::UnitX(), 4.0 * Vector::UnitY(), 5);
  const Triangles plane = withDroplet;
  double height = 0.0;
  for (const auto& triangle : sphereSurface({ 1.9, 2.2, 0.7 }, 0.3, 2))
  {
    withDroplet.push_back(triangle);
    height = std::max({ height, triangle[0].z(), triangle[1].z(), triangle[2].z() });
  }
  const HausdorffDistance found = distance(withDroplet, plane, 1e-4);
  expectWithin(found.originalToRepresented, height, 1e-4);
  expectWithin(found.representedToOriginal, 0.0, 1e-4);
}

TEST(Hausdorff, AnInscribedSphereIsAsFarInsideAsItsFlattestFace)
{
  // The faces of the coarse sphere lie between the radius and the smallest distance of a face from the center.
  const Triangles coarse = sphereSurface(Vector::Zero(), 1.0, 1);
  const Triangles fine = sphereSurface(Vector::Zero(), 1.0, 5);
  double smallest = 1.0;
  for (const auto& [a, b, c] : coarse)
  {
    smallest = std::min(smallest, std::abs(a.dot((b - a).cross(c - a).normalized())));
  }
  const HausdorffDistance found = distance(coarse, fine, 1e-3);
  // The fine sphere is inscribed too: at most 1 - cos(its half angle), below 6e-4, inside the round one.
  EXPECT_LE(found.originalToRepresented.lower, 1.0 - smallest);
  EXPECT_GE(found.originalToRepresented.upper, 1.0 - smallest - 6e-4);
  EXPECT_LE(found.originalToRepresented.upper - found.originalToRepresented.lower, 1e-3);
}

TEST(Hausdorff, TheIntervalHoldsRandomPointsOfRandomSoups)
{
  for (const std::uint64_t seed : { 1u, 2u, 3u, 4u })
  {
    std::mt19937_64 random(seed);
    const Triangles a = randomSoup(random, 12, 0.4);
    const Triangles b = randomSoup(random, 15, 0.8);
    const double tolerance = 2e-3;
    const HausdorffDistance found = distance(a, b, tolerance);
    const double aToB = sampledDistance(random, a, b, 100000);
    const double bToA = sampledDistance(random, b, a, 100000);
    EXPECT_GE(found.originalToRepresented.upper, aToB) << "seed " << seed;
    EXPECT_GE(found.representedToOriginal.upper, bToA) << "seed " << seed;
    // 6 667 points on a triangle of edge 0.4 to 0.8 leave no hole wider than 0.03.
    EXPECT_LE(found.originalToRepresented.lower, aToB + 0.03) << "seed " << seed;
    EXPECT_LE(found.representedToOriginal.lower, bToA + 0.03) << "seed " << seed;
    EXPECT_LE(found.originalToRepresented.upper - found.originalToRepresented.lower, tolerance + 1e-12);
    EXPECT_LE(found.representedToOriginal.upper - found.representedToOriginal.lower, tolerance + 1e-12);
  }
}

TEST(Hausdorff, TheIntervalHoldsRandomPointsOfShiftedSpheres)
{
  std::mt19937_64 random(5);
  const Triangles a = sphereSurface({ 0, 0, 0 }, 1.0, 2);
  const Triangles b = sphereSurface({ 0.1, 0.05, 0 }, 0.9, 1);
  const HausdorffDistance found = distance(a, b, 1e-3);
  EXPECT_GE(found.originalToRepresented.upper, sampledDistance(random, a, b, 100000));
  EXPECT_GE(found.representedToOriginal.upper, sampledDistance(random, b, a, 100000));
}

TEST(Hausdorff, ATighterToleranceGivesAnIntervalInsideTheLooserOne)
{
  std::mt19937_64 random(6);
  const Triangles a = randomSoup(random, 20, 0.5);
  const Triangles b = randomSoup(random, 20, 0.5);
  const DistanceInterval loose = distance(a, b, 1e-1).originalToRepresented;
  const DistanceInterval tight = distance(a, b, 1e-5).originalToRepresented;
  EXPECT_LE(loose.lower, tight.lower);
  EXPECT_GE(loose.upper, tight.upper);
  EXPECT_LE(tight.upper - tight.lower, 1e-5 + 1e-12);
}

TEST(Hausdorff, TheFarthestPointMayLieBetweenCornersThatAreClose)
{
  // All corners of the triangle lie on the other surface: a segment along the base and a point at the apex. On a leg,
  // at height y, the base is y away and the apex (1 - y) sqrt(5) / 2: equally far at y = sqrt(5) / (2 + sqrt(5)).
  const Triangles triangle = { { Vector(0, 0, 0), Vector(1, 0, 0), Vector(0.5, 1, 0) } };
  const Triangles corners = { { Vector(0, 0, 0), Vector(0, 0, 0), Vector(1, 0, 0) },
    { Vector(0.5, 1, 0), Vector(0.5, 1, 0), Vector(0.5, 1, 0) } };
  const double truth = std::sqrt(5.0) / (2.0 + std::sqrt(5.0));
  for (const double tolerance : { 1.0, 0.3, 0.1, 1e-4 })
  {
    expectWithin(distance(triangle, corners, tolerance).originalToRepresented, truth, tolerance);
  }
}

TEST(Hausdorff, PointsAndSegmentsCountAsDegenerateTriangles)
{
  const Vector p(1, 2, 3);
  const Vector q(1, 2, 5);
  const HausdorffDistance found = distance({ { p, p, p } }, { { p, q, q } }, 1e-6);
  expectWithin(found.originalToRepresented, 0.0, 1e-6);
  expectWithin(found.representedToOriginal, 2.0, 1e-6);
}

TEST(Hausdorff, AnEmptySurfaceIsInfinitelyFarAndTwoAreEqual)
{
  const Triangles square = parallelogram({ 0, 0, 0 }, Vector::UnitX(), Vector::UnitY(), 1);
  const HausdorffDistance lost = distance(square, {}, 1e-3);
  EXPECT_TRUE(std::isinf(lost.originalToRepresented.lower));
  EXPECT_TRUE(std::isinf(lost.originalToRepresented.upper));
  EXPECT_EQ(lost.representedToOriginal.upper, 0.0);
  EXPECT_TRUE(std::isinf(distance({}, square, 1e-3).representedToOriginal.lower));
  EXPECT_EQ(distance({}, {}, 1e-3).originalToRepresented.upper, 0.0);
}

TEST(Hausdorff, ASearchThatIsCutShortStillBoundsTheDistance)
{
  const Triangles coarse = parallelogram({ 0, 0, 0 }, Vector::UnitX(), Vector::UnitY(), 1);
  const Triangles fine = parallelogram({ 0, 0, 0.125 }, Vector::UnitX(), Vector::UnitY(), 16);
  Progress progress;
  const DistanceInterval found = directedDistance(coarse, TriangleTree(fine), 1e-4, progress, 1);
  EXPECT_LE(found.lower, 0.125);
  EXPECT_GE(found.upper, 0.125);
  EXPECT_GT(found.upper - found.lower, 1e-4);
}

TEST(Hausdorff, BadInputNamesItsValue)
{
  const Triangles square = parallelogram({ 0, 0, 0 }, Vector::UnitX(), Vector::UnitY(), 1);
  Triangles broken = square;
  broken[1][2].x() = std::nan("");
  EXPECT_THROW(distance(square, square, 0.0), InvalidInput);
  EXPECT_THROW(distance(square, square, std::nan("")), InvalidInput);
  EXPECT_THROW(distance(square, broken, 1e-3), InvalidInput);
}

TEST(Hausdorff, OneAndTwoThreadsGiveTheSameBytes)
{
  const Triangles a = sphereSurface({ 0, 0, 0 }, 1.0, 3);
  const Triangles b = sphereSurface({ 0.01, 0, 0 }, 1.0, 4);
  const HausdorffDistance many = distance(a, b, 1e-4);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const HausdorffDistance single = distance(a, b, 1e-4);
  EXPECT_EQ(many.originalToRepresented.lower, single.originalToRepresented.lower);
  EXPECT_EQ(many.originalToRepresented.upper, single.originalToRepresented.upper);
  EXPECT_EQ(many.representedToOriginal.lower, single.representedToOriginal.lower);
  EXPECT_EQ(many.representedToOriginal.upper, single.representedToOriginal.upper);
}

TEST(Hausdorff, StopsInTheMiddleWhenTheUserAsks)
{
  const Triangles a = sphereSurface({ 0, 0, 0 }, 1.0, 5);
  const Triangles b = sphereSurface({ 1e-3, 0, 0 }, 1.0, 5);
  int calls = 0;
  Progress progress([&calls](const std::string&, double) { return ++calls < 2; });
  progress.stage("Measure", 0.0, 1.0);
  EXPECT_THROW(hausdorffDistance({ a }, { b }, 1e-9, progress), Cancelled);
}
