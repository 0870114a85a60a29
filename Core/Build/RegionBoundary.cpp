#include "Build/RegionBoundary.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace strata
{
namespace
{
/// A point this close to a wall of the box lies on it (relative to the diagonal).
constexpr double wallTolerance = 1e-9;

Vector unitNormal(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector n = (b - a).cross(c - a);
  const double length = n.norm();
  return length > 0.0 ? Vector(n / length) : Vector::Zero();
}

double angleAt(const Vector& corner, const Vector& b, const Vector& c)
{
  const Vector u = b - corner;
  const Vector v = c - corner;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// Where the surface ends at a wall of the box, its mirror image continues it: the normals of the two add up
/// to one that lies in the wall.
void closeAtWalls(Vector& normal, const Box& box, std::initializer_list<Vector> feature)
{
  const double tolerance = wallTolerance * box.diagonal();
  for (int axis = 0; axis < 3; ++axis)
  {
    bool onLower = true;
    bool onUpper = true;
    for (const Vector& p : feature)
    {
      onLower = onLower && std::abs(p[axis] - box.lower[axis]) <= tolerance;
      onUpper = onUpper && std::abs(p[axis] - box.upper[axis]) <= tolerance;
    }
    if (onLower || onUpper)
    {
      normal[axis] = 0.0;
    }
  }
}

/// Squares along each wall of the box, each of which lies within a region or not.
constexpr int wallSquares = 32;
/// Ways that say whether one of them lies within it.
constexpr std::size_t votes = 61;
/// From this part of all directions on, a point from which the surface is seen from behind lies inside.
constexpr double insideWindingNumber = 0.5;

/// A square of a wall, its corners counter-clockwise seen from outside of the box.
struct WallSquare
{
  std::array<Vector, 4> corners;
  bool inside = false;
  bool known = false; ///< by the closest feature of the surface
  Vector middle() const { return 0.5 * (corners[0] + corners[2]); }
};

std::vector<WallSquare> wallSquaresOf(const Box& box)
{
  std::vector<WallSquare> result;
  for (int wall = 0; wall < 6; ++wall)
  {
    const int axis = wall % 3;
    const bool upper = wall >= 3;
    const int u = (axis + (upper ? 1 : 2)) % 3;
    const int v = (axis + (upper ? 2 : 1)) % 3;
    const auto at = [&](int i, int j) {
      Vector place;
      place[axis] = upper ? box.upper[axis] : box.lower[axis];
      place[u] = box.lower[u] + box.size()[u] * i / wallSquares;
      place[v] = box.lower[v] + box.size()[v] * j / wallSquares;
      return place;
    };
    for (int square = 0; square < wallSquares * wallSquares; ++square)
    {
      const int i = square % wallSquares;
      const int j = square / wallSquares;
      result.push_back({ { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) } });
    }
  }
  return result;
}

std::array<Vector, 3> cornersOf(const std::vector<Vector>& points, const SurfaceTriangle& t)
{
  return { points[t[0]], points[t[1]], points[t[2]] };
}
}

RegionBoundary::RegionBoundary(
  const Interfaces& interfaces, MaterialId material, const Box& box, DistanceMethod method, bool fillsBox) :
  box_(box),
  fillsBox_(fillsBox)
{
  const std::vector<SurfaceTriangle> triangles = outwardTriangles(interfaces, material);
  if (!triangles.empty())
  {
    makeNormals(interfaces.points, triangles);
    if (method == DistanceMethod::ClosestPoint)
    {
      findOpenFeatures(interfaces.points, triangles);
    }
    makeTree(interfaces.points, triangles, method);
    if (!open_.empty())
    {
      makeWinding(interfaces.points, triangles);
    }
  }
}

void RegionBoundary::makeNormals(const std::vector<Vector>& points, const std::vector<SurfaceTriangle>& triangles)
{
  std::vector<Vector> ofVertex(points.size(), Vector::Zero());
  for (const SurfaceTriangle& t : triangles)
  {
    const Vector normal = unitNormal(points[t[0]], points[t[1]], points[t[2]]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      ofVertex[t[i]] += angleAt(points[t[i]], points[t[(i + 1) % 3]], points[t[(i + 2) % 3]]) * normal;
    }
  }
  normals_.resize(triangles.size());
  tbb::parallel_for(std::size_t{ 0 }, triangles.size(), [&](std::size_t i) {
    const SurfaceTriangle& t = triangles[i];
    normals_[i][6] = unitNormal(points[t[0]], points[t[1]], points[t[2]]);
  });
  const std::vector<EdgeUse> uses = sortedEdgeUses(triangles);
  for (std::size_t begin = 0; begin < uses.size();)
  {
    const EdgeUse& first = uses[begin];
    std::size_t end = begin;
    Vector sum = Vector::Zero();
    for (; end < uses.size() && uses[end].low == first.low && uses[end].high == first.high; ++end)
    {
      sum += normals_[uses[end].triangle][6];
    }
    if (end == begin + 1)
    {
      closeAtWalls(sum, box_, { points[first.low], points[first.high] });
      closeAtWalls(ofVertex[first.low], box_, { points[first.low] });
      closeAtWalls(ofVertex[first.high], box_, { points[first.high] });
    }
    for (; begin < end; ++begin)
    {
      normals_[uses[begin].triangle][3 + uses[begin].edge] = sum;
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      normals_[i][k] = ofVertex[triangles[i][k]];
    }
  }
}

void RegionBoundary::makeTree(
  const std::vector<Vector>& points, const std::vector<SurfaceTriangle>& triangles, DistanceMethod method)
{
  std::vector<std::array<Vector, 3>> corners;
  if (method == DistanceMethod::ClosestPoint)
  {
    std::transform(triangles.begin(), triangles.end(), std::back_inserter(corners),
      [&](const SurfaceTriangle& t) { return cornersOf(points, t); });
    tree_ = std::make_unique<TriangleTree>(std::move(corners));
    return;
  }
  // The paper's rule: a triangle that has shrunk to a point stands for each vertex.
  std::map<std::int32_t, Vector> normalOfVertex;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      normalOfVertex.emplace(triangles[i][k], normals_[i][k]);
    }
  }
  normals_.clear();
  for (const auto& [vertex, normal] : normalOfVertex)
  {
    corners.push_back({ points[vertex], points[vertex], points[vertex] });
    FeatureNormals same;
    same.fill(normal);
    normals_.push_back(same);
  }
  tree_ = std::make_unique<TriangleTree>(std::move(corners));
}

void RegionBoundary::findOpenFeatures(const std::vector<Vector>& points, const std::vector<SurfaceTriangle>& triangles)
{
  const std::vector<EdgeUse> uses = sortedEdgeUses(triangles);
  std::vector<std::uint8_t> openPoints(points.size(), 0);
  std::vector<OpenFeatures> open(triangles.size());
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end)
  {
    const EdgeUse& first = uses[begin];
    while (end < uses.size() && uses[end].low == first.low && uses[end].high == first.high)
    {
      ++end;
    }
    if (isClosed(uses.data() + begin, uses.data() + end) || endsAtWall(box_, { points[first.low], points[first.high] }))
    {
      continue;
    }
    openPoints[first.low] = openPoints[first.high] = 1;
    for (std::size_t use = begin; use < end; ++use)
    {
      open[uses[use].triangle].set(3 + uses[use].edge);
    }
  }
  bool any = false;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      open[i].set(k, openPoints[triangles[i][k]] != 0);
    }
    any = any || open[i].any();
  }
  if (any)
  {
    open_ = std::move(open);
  }
}

void RegionBoundary::makeWinding(const std::vector<Vector>& points, const std::vector<SurfaceTriangle>& triangles)
{
  std::vector<std::array<Vector, 3>> closed;
  std::transform(triangles.begin(), triangles.end(), std::back_inserter(closed),
    [&](const SurfaceTriangle& t) { return cornersOf(points, t); });
  const WindingNumber surface(closed);
  std::vector<WallSquare> squares = wallSquaresOf(box_);
  std::vector<const WallSquare*> known;
  for (WallSquare& square : squares)
  {
    const TriangleTree::Hit hit = tree_->closest(square.middle());
    square.inside = isBehind(hit, square.middle());
    square.known = !isOpen(hit);
  }
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    if (squares[i].known)
    {
      known.push_back(&squares[i]);
    }
  }
  // The parts of the box's walls that lie in the region close its surface. Where the closest feature doesn't tell, most
  // of the ways to places where it does must.
  const std::size_t stride = known.size() / votes + 1;
  for (WallSquare& square : squares)
  {
    int inside = 0;
    int asked = 0;
    for (std::size_t i = 0; i < known.size() && !square.known; i += stride)
    {
      inside += (known[i]->inside ? 1 : 0) + surface.crossings(square.middle(), known[i]->middle());
      ++asked;
    }
    square.inside = asked > 0 ? 2 * inside > asked : square.inside;
    if (square.inside)
    {
      closed.push_back({ square.corners[0], square.corners[1], square.corners[2] });
      closed.push_back({ square.corners[0], square.corners[2], square.corners[3] });
    }
  }
  winding_ = std::make_unique<WindingNumber>(std::move(closed));
}

bool RegionBoundary::isOpen(const TriangleTree::Hit& hit) const
{
  return !open_.empty() && open_[static_cast<std::size_t>(hit.triangle)].test(static_cast<std::size_t>(hit.feature));
}

bool RegionBoundary::isBehind(const TriangleTree::Hit& hit, const Vector& point) const
{
  const Vector& normal = normals_[static_cast<std::size_t>(hit.triangle)][static_cast<std::size_t>(hit.feature)];
  return normal.dot(point - hit.point) <= 0.0;
}

RegionPoint RegionBoundary::locate(const Vector& point) const
{
  if (!tree_)
  {
    // A material without a region is farther away than anything in the box.
    return { fillsBox_, fillsBox_ ? 0.0 : box_.diagonal(), point };
  }
  const TriangleTree::Hit hit = tree_->closest(point);
  const bool inside = isOpen(hit) ? winding_->at(point) >= insideWindingNumber : isBehind(hit, point);
  if (inside)
  {
    return { true, 0.0, point };
  }
  return { false, std::sqrt(hit.squaredDistance), hit.point };
}
}
