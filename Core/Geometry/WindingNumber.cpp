#include "Geometry/WindingNumber.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr std::int32_t trianglesPerLeaf = 8;
/// A node counts as a dipole from this many of its radii on.
constexpr double dipoleDistance = 3.0;
constexpr double fullAngle = 4.0 * 3.14159265358979323846;

Vector areaVector(const std::array<Vector, 3>& t)
{
  return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
}

Vector centerOf(const std::array<Vector, 3>& t)
{
  return (t[0] + t[1] + t[2]) / 3.0;
}

/// The solid angle of a triangle (Van Oosterom and Strackee 1983), positive seen from behind.
double solidAngle(const std::array<Vector, 3>& t, const Vector& point)
{
  const Vector a = t[0] - point;
  const Vector b = t[1] - point;
  const Vector c = t[2] - point;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double volume = a.dot(b.cross(c));
  const double cosine = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2.0 * std::atan2(volume, cosine);
}
/// 1 if the way leads through the triangle along its normal, -1 against it, 0 if it misses it.
int crossing(const std::array<Vector, 3>& t, const Vector& from, const Vector& way)
{
  const Vector ab = t[1] - t[0];
  const Vector ac = t[2] - t[0];
  const Vector normal = ab.cross(ac);
  const double speed = normal.dot(way);
  const Vector offset = from - t[0];
  if (speed == 0.0)
  {
    return 0;
  }
  // Cramer's rule for where the line meets the plane of the triangle.
  const double time = -normal.dot(offset) / speed;
  const Vector turned = way.cross(offset);
  const double u = ac.dot(turned) / speed;
  const double v = -ab.dot(turned) / speed;
  const bool meets = time >= 0.0 && time < 1.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0;
  return meets ? (speed > 0.0 ? 1 : -1) : 0;
}

double squaredDistanceToWay(const Vector& p, const Vector& from, const Vector& way)
{
  const double time = std::clamp((p - from).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
  return (from + time * way - p).squaredNorm();
}
}

WindingNumber::WindingNumber(std::vector<std::array<Vector, 3>> triangles) : triangles_(std::move(triangles))
{
  if (!triangles_.empty())
  {
    build(0, static_cast<std::int32_t>(triangles_.size()));
  }
}

WindingNumber::Node WindingNumber::summary(std::int32_t begin, std::int32_t end) const
{
  Node node;
  double area = 0.0;
  for (std::int32_t i = begin; i < end; ++i)
  {
    const Vector normal = areaVector(triangles_[i]);
    node.normal += normal;
    node.center += normal.norm() * centerOf(triangles_[i]);
    area += normal.norm();
  }
  node.center = area > 0.0 ? Vector(node.center / area) : centerOf(triangles_[begin]);
  for (std::int32_t i = begin; i < end; ++i)
  {
    for (const Vector& corner : triangles_[i])
    {
      node.radius = std::max(node.radius, (corner - node.center).norm());
    }
  }
  return node;
}

std::int32_t WindingNumber::build(std::int32_t begin, std::int32_t end)
{
  const auto id = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back(summary(begin, end));
  if (end - begin <= trianglesPerLeaf)
  {
    nodes_[id].first = begin;
    nodes_[id].count = end - begin;
    return id;
  }
  Box centers;
  std::for_each(triangles_.begin() + begin, triangles_.begin() + end,
    [&](const std::array<Vector, 3>& t) { centers.add(centerOf(t)); });
  Eigen::Index axis = 0;
  centers.size().maxCoeff(&axis);
  const std::int32_t middle = begin + (end - begin) / 2;
  std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
    [&](const auto& a, const auto& b) { return centerOf(a)[axis] < centerOf(b)[axis]; });
  build(begin, middle);
  const std::int32_t second = build(middle, end);
  nodes_[id].second = second;
  return id;
}

double WindingNumber::angleFrom(std::int32_t node, const Vector& point) const
{
  const Node& n = nodes_[node];
  const Vector offset = n.center - point;
  const double distance = offset.norm();
  if (distance > dipoleDistance * n.radius)
  {
    return n.normal.dot(offset) / (distance * distance * distance);
  }
  if (n.count == 0)
  {
    return angleFrom(node + 1, point) + angleFrom(n.second, point);
  }
  double sum = 0.0;
  for (std::int32_t i = n.first; i < n.first + n.count; ++i)
  {
    sum += solidAngle(triangles_[i], point);
  }
  return sum;
}

double WindingNumber::at(const Vector& point) const
{
  return nodes_.empty() ? 0.0 : angleFrom(0, point) / fullAngle;
}

int WindingNumber::crossingsOf(std::int32_t node, const Vector& from, const Vector& way) const
{
  const Node& n = nodes_[node];
  if (squaredDistanceToWay(n.center, from, way) > n.radius * n.radius)
  {
    return 0;
  }
  if (n.count == 0)
  {
    return crossingsOf(node + 1, from, way) + crossingsOf(n.second, from, way);
  }
  int sum = 0;
  for (std::int32_t i = n.first; i < n.first + n.count; ++i)
  {
    sum += crossing(triangles_[i], from, way);
  }
  return sum;
}

int WindingNumber::crossings(const Vector& from, const Vector& to) const
{
  return nodes_.empty() ? 0 : crossingsOf(0, from, to - from);
}
}
