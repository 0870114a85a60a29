#pragma once

#include "Geometry/Box.h"
#include "Model/Interfaces.h"

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace strata
{
/// Corners of a triangle among the points of interfaces.
using SurfaceTriangle = std::array<std::int32_t, 3>;

/// The triangles of all surfaces that bound the material, turned so that their normals point out of it.
std::vector<SurfaceTriangle> outwardTriangles(const Interfaces& interfaces, MaterialId material);

/// An edge of a triangle; `edge` counts as TriangleFeature does.
struct EdgeUse
{
  std::int32_t low;
  std::int32_t high;
  std::uint32_t triangle;
  std::uint32_t edge;
  bool forward; ///< the triangle goes round from low to high
};

/// All edges of all triangles; those that triangles share stand together.
std::vector<EdgeUse> sortedEdgeUses(const std::vector<SurfaceTriangle>& triangles);

/// True if triangles go along an edge as often in one direction as in the other: the surface goes on there.
bool isClosed(const EdgeUse* begin, const EdgeUse* end);

/// True if all the points lie on one wall of the box, or beyond it: a surface may end there.
bool endsAtWall(const Box& box, std::initializer_list<Vector> points);

/// Where the surface round a material's region is open within the box: which side a point near it lies on is not
/// said by the surface.
struct OpenBorder
{
  MaterialId material;
  Index edges = 0;
  double length = 0.0;
  Vector lower; ///< the box round the longest connected part: a gap of this size
  Vector upper;
  /// How far from the edges of that part the material may be wrong: half its size, or, for a surface that ends before
  /// the walls, the largest distance to them, if that is less.
  double reach = 0.0;
};

/// The materials whose surfaces are open, in order; none for surfaces that are closed up to the box's walls.
std::vector<OpenBorder> openBorders(const Interfaces& interfaces, Index materialCount, const Box& box);
}
