#include "Measure/OriginalMaterial.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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

/// The corners (bits 0 to 2) that span a triangle's feature.
unsigned cornersOf(TriangleFeature feature)
{
  switch (feature)
  {
    case TriangleFeature::Corner0:
      return 1u;
    case TriangleFeature::Corner1:
      return 2u;
    case TriangleFeature::Corner2:
      return 4u;
    case TriangleFeature::Edge01:
      return 3u;
    case TriangleFeature::Edge12:
      return 6u;
    case TriangleFeature::Edge20:
      return 5u;
    case TriangleFeature::Face:
      break;
  }
  return 7u;
}
}

OriginalMaterial::OriginalMaterial(const Interfaces& interfaces, MaterialId withoutInterfaces) :
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
}

/// The triangles that contain the feature on which the closest point lies.
void OriginalMaterial::gatherCandidates(const TriangleTree::Hit& hit, std::vector<std::int32_t>& candidates) const
{
  const unsigned feature = cornersOf(hit.feature);
  if (feature == 7u)
  {
    candidates.push_back(hit.triangle);
    return;
  }
  const std::array<std::int32_t, 3>& corners = sides_[hit.triangle].corners;
  const int first = (feature & 1u) ? 0 : ((feature & 2u) ? 1 : 2);
  for (std::int32_t i = aroundStart_[corners[first]]; i < aroundStart_[corners[first] + 1]; ++i)
  {
    const std::array<std::int32_t, 3>& others = sides_[around_[i]].corners;
    bool containsAll = true;
    for (int corner = 0; corner < 3; ++corner)
    {
      const bool needed = (feature >> corner) & 1u;
      containsAll =
        containsAll && (!needed || std::find(others.begin(), others.end(), corners[corner]) != others.end());
    }
    if (containsAll)
    {
      candidates.push_back(around_[i]);
    }
  }
}

OriginalMaterial::Answer OriginalMaterial::at(const Vector& p) const
{
  const TriangleTree::Hit hit = tree_.closest(p);
  if (hit.triangle < 0)
  {
    return { withoutInterfaces_, hit.squaredDistance };
  }
  std::vector<std::int32_t> candidates;
  gatherCandidates(hit, candidates);
  double squarest = -1.0;
  Answer answer{ withoutInterfaces_, std::sqrt(hit.squaredDistance) };
  for (const std::int32_t candidate : candidates)
  {
    const auto& [a, b, c] = tree_.triangles()[candidate];
    const Vector normal = (b - a).cross(c - a).normalized();
    const double height = normal.dot(p - hit.point);
    if (std::abs(height) > squarest)
    {
      squarest = std::abs(height);
      answer.material = height >= 0.0 ? sides_[candidate].positive : sides_[candidate].negative;
    }
  }
  return answer;
}

OriginalMaterial::Answer OriginalMaterial::at(const Vector& p, double needed, Ball& last) const
{
  const double distance = last.answer.distance - (p - last.center).norm();
  if (distance > needed)
  {
    return { last.answer.material, distance };
  }
  last = { p, at(p) };
  return last.answer;
}
}
