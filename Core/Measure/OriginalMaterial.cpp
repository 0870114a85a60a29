#include "Measure/OriginalMaterial.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace strata
{
namespace
{
std::vector<std::array<Vector, 3>> trianglesOf(const Interfaces& interfaces)
{
  std::vector<std::array<Vector, 3>> triangles;
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    for (const auto& [a, b, c] : surface.triangles)
    {
      triangles.push_back({ interfaces.points[a], interfaces.points[b], interfaces.points[c] });
    }
  }
  return triangles;
}

/// Surfaces may end at the walls of the box, to this part of its diagonal.
constexpr double wallTolerance = 1e-9;

bool isOnOneWall(const Box& box, const Vector& a, const Vector& b)
{
  const double tolerance = wallTolerance * box.diagonal();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::max(a[axis], b[axis]) <= box.lower[axis] + tolerance ||
        std::min(a[axis], b[axis]) >= box.upper[axis] - tolerance)
    {
      return true;
    }
  }
  return false;
}

/// The corners at the ends of the feature on which a point lies; twice the same for a corner.
std::array<int, 2> endsOf(TriangleFeature feature)
{
  switch (feature)
  {
    case TriangleFeature::Corner1:
      return { 1, 1 };
    case TriangleFeature::Corner2:
      return { 2, 2 };
    case TriangleFeature::Edge01:
      return { 0, 1 };
    case TriangleFeature::Edge12:
      return { 1, 2 };
    case TriangleFeature::Edge20:
      return { 2, 0 };
    default:
      return { 0, 0 };
  }
}
}

OriginalMaterial::OriginalMaterial(const Interfaces& interfaces, const Box& box, MaterialId withoutInterfaces) :
  interfaces_(interfaces), withoutInterfaces_(withoutInterfaces), aroundStart_(interfaces.points.size() + 1, 0),
  tree_(trianglesOf(interfaces))
{
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    for (const auto& corners : surface.triangles)
    {
      sides_.push_back({ surface.positive, surface.negative, corners });
      for (const std::int32_t corner : corners)
      {
        ++aroundStart_[static_cast<std::size_t>(corner) + 1];
      }
    }
  }
  std::partial_sum(aroundStart_.begin(), aroundStart_.end(), aroundStart_.begin());
  around_.resize(3 * sides_.size());
  std::vector<std::int32_t> next(aroundStart_.begin(), aroundStart_.end() - 1);
  for (std::size_t triangle = 0; triangle < sides_.size(); ++triangle)
  {
    for (const std::int32_t corner : sides_[triangle].corners)
    {
      around_[next[corner]++] = static_cast<std::int32_t>(triangle);
    }
  }
  findRims(box);
}

void OriginalMaterial::findRims(const Box& box)
{
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  for (const Side& side : sides_)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      edges.push_back(std::minmax(side.corners[i], side.corners[(i + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  isOnRim_.assign(interfaces_.points.size(), 0);
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if (next == edge + 1 && !isOnOneWall(box, interfaces_.points[edge->first], interfaces_.points[edge->second]))
    {
      rims_.push_back(*edge);
      isOnRim_[edge->first] = isOnRim_[edge->second] = 1;
    }
    edge = next;
  }
}

bool OriginalMaterial::isNearGap(const TriangleTree::Hit& hit) const
{
  if (rims_.empty() || hit.feature == TriangleFeature::Face)
  {
    return false;
  }
  const auto [first, second] = endsOf(hit.feature);
  const std::array<std::int32_t, 3>& corners = sides_[hit.triangle].corners;
  return first == second ? isOnRim_[corners[first]] != 0
                         : std::binary_search(rims_.begin(), rims_.end(),
                             std::pair<std::int32_t, std::int32_t>(std::minmax(corners[first], corners[second])));
}

Vector OriginalMaterial::normal(std::int32_t triangle) const
{
  const auto& [a, b, c] = tree_.triangles()[triangle];
  return (b - a).cross(c - a).normalized();
}

/// The far end of the edge at a corner that has the smallest angle with a direction.
std::int32_t OriginalMaterial::edgeTowards(std::int32_t corner, const Vector& direction) const
{
  std::int32_t best = corner;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::int32_t i = aroundStart_[corner]; i < aroundStart_[corner + 1]; ++i)
  {
    for (const std::int32_t end : sides_[around_[i]].corners)
    {
      const double cosine = (interfaces_.points[end] - interfaces_.points[corner]).normalized().dot(direction);
      if (end != corner && cosine > largest)
      {
        largest = cosine;
        best = end;
      }
    }
  }
  return best;
}

/// The material in which a point lies, given its offset from its closest point on an edge between two corners.
MaterialId OriginalMaterial::sideOf(const Vector& offset, std::int32_t corner, std::int32_t otherCorner) const
{
  MaterialId material;
  double squarest = -1.0;
  for (std::int32_t i = aroundStart_[corner]; i < aroundStart_[corner + 1]; ++i)
  {
    const Side& side = sides_[around_[i]];
    const double height = normal(around_[i]).dot(offset);
    if (std::abs(height) > squarest &&
        std::find(side.corners.begin(), side.corners.end(), otherCorner) != side.corners.end())
    {
      squarest = std::abs(height);
      material = height >= 0.0 ? side.positive : side.negative;
    }
  }
  return material;
}

MaterialId OriginalMaterial::sideOf(const Vector& offset, const TriangleTree::Hit& hit) const
{
  const Side& side = sides_[hit.triangle];
  if (hit.feature == TriangleFeature::Face)
  {
    return normal(hit.triangle).dot(offset) >= 0.0 ? side.positive : side.negative;
  }
  const auto [first, second] = endsOf(hit.feature);
  const std::int32_t corner = side.corners[first];
  return sideOf(offset, corner, first == second ? edgeTowards(corner, offset) : side.corners[second]);
}

OriginalMaterial::Answer OriginalMaterial::at(const Vector& p) const
{
  const TriangleTree::Hit hit = tree_.closest(p);
  if (hit.triangle < 0)
  {
    return { withoutInterfaces_, std::sqrt(hit.squaredDistance) };
  }
  return { sideOf(p - hit.point, hit), std::sqrt(hit.squaredDistance), isNearGap(hit) };
}

OriginalMaterial::Answer OriginalMaterial::at(const Vector& p, double needed, Ball& last) const
{
  const double distance = last.answer.distance - (p - last.center).norm();
  if (distance > needed && !hasGaps())
  {
    return { last.answer.material, distance };
  }
  last = { p, at(p) };
  return last.answer;
}
}
