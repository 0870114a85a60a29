#include "Build/RegionBoundary.h"

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <unordered_map>

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

std::uint64_t edgeKey(std::int32_t a, std::int32_t b)
{
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  const auto high = static_cast<std::uint64_t>(std::max(a, b));
  return (high << 32) | low;
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

struct EdgeNormal
{
  Vector sum = Vector::Zero();
  int triangles = 0;
};

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
  std::unordered_map<std::int32_t, Vector> ofVertex;
  std::unordered_map<std::uint64_t, EdgeNormal> ofEdge;
  for (const Triangle& t : triangles)
  {
    const Vector normal = unitNormal(points[t[0]], points[t[1]], points[t[2]]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int32_t a = t[i];
      const std::int32_t b = t[(i + 1) % 3];
      const std::int32_t c = t[(i + 2) % 3];
      ofVertex.emplace(a, Vector::Zero()).first->second += angleAt(points[a], points[b], points[c]) * normal;
      EdgeNormal& edge = ofEdge[edgeKey(a, b)];
      edge.sum += normal;
      ++edge.triangles;
    }
  }
  for (auto& [key, edge] : ofEdge)
  {
    if (edge.triangles == 1)
    {
      const auto a = static_cast<std::int32_t>(key & 0xFFFFFFFFu);
      const auto b = static_cast<std::int32_t>(key >> 32);
      closeAtWalls(edge.sum, box_, { points[a], points[b] });
      closeAtWalls(ofVertex.at(a), box_, { points[a] });
      closeAtWalls(ofVertex.at(b), box_, { points[b] });
    }
  }
  normals_.reserve(triangles.size());
  for (const Triangle& t : triangles)
  {
    normals_.push_back({ ofVertex.at(t[0]), ofVertex.at(t[1]), ofVertex.at(t[2]), ofEdge.at(edgeKey(t[0], t[1])).sum,
      ofEdge.at(edgeKey(t[1], t[2])).sum, ofEdge.at(edgeKey(t[2], t[0])).sum,
      unitNormal(points[t[0]], points[t[1]], points[t[2]]) });
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
