#pragma once

#include "Geometry/Vector.h"

#include <array>
#include <cstdint>

namespace strata
{
/// The part of a triangle on which a point lies.
enum class TriangleFeature : std::uint8_t
{
  Corner0,
  Corner1,
  Corner2,
  Edge01,
  Edge12,
  Edge20,
  Face
};

struct ClosestPoint
{
  Vector point;
  TriangleFeature feature = TriangleFeature::Face;
};

/// The point of a triangle closest to `p`, by the Voronoi regions of its features (Ericson, Real-Time Collision
/// Detection, 5.1.5). A degenerate triangle is treated as the segment or point that it is.
ClosestPoint closestPointOnTriangle(const Vector& p, const std::array<Vector, 3>& triangle);
}
