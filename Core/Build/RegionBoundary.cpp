#include "Build/RegionBoundary.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace strata
{
namespace
{
using Triangle = std::array<std::int32_t, 3>;

/// A point this close to a wall of the box lies on it (relative to the diagonal).
constexpr double wallTolerance = 1e-9;

/// The triangles of all surfaces that bound the material, turned so that their normals point out of it.
std::vector<Triangle> outwardTriangles(const Interfaces& interfaces, MaterialId material)
{
  std::vector<Triangle> result;
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    if (surface.negative == material)
    {
      result.insert(result.end(), surface.triangles.begin(), surface.triangles.end());
    }
    else if (surface.positive == material)
    {
      for (const Triangle& t : surface.triangles)
      {
        result.push_back({ t[0], t[2], t[1] });
      }
    }
  }
  return result;
}

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

/// An edge of a triangle; `edge` counts as TriangleFeature does.
struct EdgeUse
{
  std::int32_t low;
  std::int32_t high;
  std::uint32_t triangle;
  std::uint32_t edge;
};

/// All edges of all triangles; those that triangles share stand together.
std::vector<EdgeUse> sortedEdgeUses(const std::vector<Triangle>& triangles)
{
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
  {
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax({ triangles[i][k], triangles[i][(k + 1) % 3] });
      uses.push_back({ low, high, i, k });
    }
  }
  tbb::parallel_sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle, a.edge) < std::tie(b.low, b.high, b.triangle, b.edge);
  });
  return uses;
}
}

RegionBoundary::RegionBoundary(
  const Interfaces& interfaces, MaterialId material, const Box& box, DistanceMethod method, bool fillsBox) :
  box_(box),
  fillsBox_(fillsBox)
{
  const std::vector<Triangle> triangles = outwardTriangles(interfaces, material);
  if (!triangles.empty())
  {
    makeNormals(interfaces.points, triangles);
    makeTree(interfaces.points, triangles, method);
  }
}

void RegionBoundary::makeNormals(const std::vector<Vector>& points, const std::vector<Triangle>& triangles)
{
  std::vector<Vector> ofVertex(points.size(), Vector::Zero());
  for (const Triangle& t : triangles)
  {
    const Vector normal = unitNormal(points[t[0]], points[t[1]], points[t[2]]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      ofVertex[t[i]] += angleAt(points[t[i]], points[t[(i + 1) % 3]], points[t[(i + 2) % 3]]) * normal;
    }
  }
  normals_.resize(triangles.size());
  tbb::parallel_for(std::size_t{ 0 }, triangles.size(), [&](std::size_t i) {
    const Triangle& t = triangles[i];
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
  const std::vector<Vector>& points, const std::vector<Triangle>& triangles, DistanceMethod method)
{
  std::vector<std::array<Vector, 3>> corners;
  if (method == DistanceMethod::ClosestPoint)
  {
    for (const Triangle& t : triangles)
    {
      corners.push_back({ points[t[0]], points[t[1]], points[t[2]] });
    }
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

RegionPoint RegionBoundary::locate(const Vector& point) const
{
  if (!tree_)
  {
    // A material without a region is farther away than anything in the box.
    return { fillsBox_, fillsBox_ ? 0.0 : box_.diagonal(), point };
  }
  const TriangleTree::Hit hit = tree_->closest(point);
  const Vector& normal = normals_[static_cast<std::size_t>(hit.triangle)][static_cast<std::size_t>(hit.feature)];
  if (normal.dot(point - hit.point) <= 0.0)
  {
    return { true, 0.0, point };
  }
  return { false, std::sqrt(hit.squaredDistance), hit.point };
}
}
