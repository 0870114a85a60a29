#pragma once

#include "Geometry/Box.h"
#include "Model/Interfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace strata::test
{
/// Volume that a material's surfaces bound by the divergence theorem. The region must not reach the domain's
/// boundary.
inline double enclosedVolume(const Interfaces& interfaces, MaterialId material)
{
  double sixfold = 0.0;
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    // Normals point into `positive`.
    const double sign = surface.negative == material ? 1.0 : surface.positive == material ? -1.0 : 0.0;
    for (const auto& t : surface.triangles)
    {
      sixfold += sign * interfaces.points[t[0]].dot(interfaces.points[t[1]].cross(interfaces.points[t[2]]));
    }
  }
  return sixfold / 6.0;
}

/// Edges of a material's surfaces that are not matched by as many opposite ones, and don't lie in the box's sides.
inline int openEdges(const Interfaces& interfaces, MaterialId material, const Box& box)
{
  std::map<std::pair<std::int32_t, std::int32_t>, int> balance;
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    const int sign = surface.negative == material ? 1 : surface.positive == material ? -1 : 0;
    for (const auto& t : surface.triangles)
    {
      for (int i = 0; i < 3 && sign != 0; ++i)
      {
        const std::int32_t a = t[i];
        const std::int32_t b = t[(i + 1) % 3];
        balance[{ std::min(a, b), std::max(a, b) }] += a < b ? sign : -sign;
      }
    }
  }
  const double tolerance = 1e-9 * box.diagonal();
  int open = 0;
  for (const auto& [edge, count] : balance)
  {
    const Vector& a = interfaces.points[edge.first];
    const Vector& b = interfaces.points[edge.second];
    bool inSide = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (double plane : { box.lower[axis], box.upper[axis] })
      {
        inSide = inSide || (std::abs(a[axis] - plane) <= tolerance && std::abs(b[axis] - plane) <= tolerance);
      }
    }
    open += count != 0 && !inSide ? 1 : 0;
  }
  return open;
}

/// Every region is closed together with the box, triangles are neither degenerate nor double, ids ascend.
inline void expectSound(const Interfaces& interfaces, std::size_t materialCount, const Box& box)
{
  for (std::size_t m = 0; m < materialCount; ++m)
  {
    EXPECT_EQ(openEdges(interfaces, MaterialId(static_cast<Index>(m)), box), 0) << "material " << m;
  }
  std::pair<std::int32_t, std::int32_t> previous{ -1, -1 };
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    const std::pair<std::int32_t, std::int32_t> pair{ surface.positive.value, surface.negative.value };
    EXPECT_LT(pair.first, pair.second);
    EXPECT_LT(previous, pair);
    previous = pair;
    std::set<std::array<std::int32_t, 3>> seen;
    for (std::array<std::int32_t, 3> t : surface.triangles)
    {
      EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
      std::sort(t.begin(), t.end());
      EXPECT_TRUE(seen.insert(t).second) << "a triangle twice";
    }
  }
  std::set<std::array<double, 3>> positions;
  for (const Vector& p : interfaces.points)
  {
    EXPECT_TRUE(positions.insert({ p[0], p[1], p[2] }).second) << "a point twice";
  }
}
}
