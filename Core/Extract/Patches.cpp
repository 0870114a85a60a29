#include "Extract/Patches.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace strata
{
namespace
{
using Corners = std::array<std::int32_t, 3>;

/// A triangle's corners rotated so that the lowest is first: the same for the same oriented triangle.
Corners rotated(const Corners& c)
{
  const auto first = static_cast<std::size_t>(std::min_element(c.begin(), c.end()) - c.begin());
  return { c[first], c[(first + 1) % 3], c[(first + 2) % 3] };
}

bool sameCorners(const Corners& a, const Corners& b)
{
  return a[0] == b[0] && std::min(a[1], a[2]) == std::min(b[1], b[2]) && std::max(a[1], a[2]) == std::max(b[1], b[2]);
}

/// Sorts triangles (rotated) and keeps one of each kind whose two orientations don't cancel.
void removeRepetitions(std::vector<Corners>& triangles)
{
  const auto less = [](const Corners& a, const Corners& b) {
    const std::array<std::int32_t, 4> x{ a[0], std::min(a[1], a[2]), std::max(a[1], a[2]), a[1] };
    const std::array<std::int32_t, 4> y{ b[0], std::min(b[1], b[2]), std::max(b[1], b[2]), b[1] };
    return x < y;
  };
  tbb::parallel_sort(triangles.begin(), triangles.end(), less);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size();)
  {
    std::size_t end = i;
    Index balance = 0;
    for (; end < triangles.size() && sameCorners(triangles[i], triangles[end]); ++end)
    {
      balance += triangles[end] == triangles[i] ? 1 : -1;
    }
    if (balance != 0)
    {
      triangles[kept++] = balance > 0 ? triangles[i] : triangles[end - 1];
    }
    i = end;
  }
  triangles.resize(kept);
}

struct PointOfPatch
{
  std::array<double, 3> position;
  std::int32_t patch;
  std::int32_t number;
  bool operator<(const PointOfPatch& other) const
  {
    return position != other.position ? position < other.position
                                      : std::make_pair(patch, number) < std::make_pair(other.patch, other.number);
  }
};

/// Numbers the distinct positions of all patches: result[patch][number].
std::vector<std::vector<std::int32_t>> unifyPoints(
  const std::vector<SurfacePatch>& patches, std::vector<Vector>& points)
{
  std::vector<PointOfPatch> all;
  std::vector<std::vector<std::int32_t>> ids(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    ids[p].resize(patches[p].points().size());
    for (std::size_t i = 0; i < ids[p].size(); ++i)
    {
      const Vector& x = patches[p].points()[i];
      all.push_back({ { x[0], x[1], x[2] }, static_cast<std::int32_t>(p), static_cast<std::int32_t>(i) });
    }
  }
  tbb::parallel_sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (i == 0 || all[i].position != all[i - 1].position)
    {
      points.emplace_back(all[i].position[0], all[i].position[1], all[i].position[2]);
    }
    ids[all[i].patch][all[i].number] = static_cast<std::int32_t>(points.size() - 1);
  }
  return ids;
}

/// Leaves out the points that no triangle uses.
void compact(Interfaces& interfaces)
{
  std::vector<std::int32_t> renumbered(interfaces.points.size(), -1);
  std::vector<Vector> used;
  for (Interfaces::Surface& surface : interfaces.surfaces)
  {
    for (Corners& triangle : surface.triangles)
    {
      for (std::int32_t& corner : triangle)
      {
        if (renumbered[corner] < 0)
        {
          renumbered[corner] = static_cast<std::int32_t>(used.size());
          used.push_back(interfaces.points[corner]);
        }
        corner = renumbered[corner];
      }
    }
  }
  interfaces.points = std::move(used);
}
}

std::size_t SurfacePatch::Hash::operator()(const Vector& position) const
{
  std::size_t hash = 0;
  for (double x : position)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return hash;
}

std::int32_t SurfacePatch::addPoint(const Vector& position)
{
  const Vector point = position + Vector::Zero(); // one zero, not two
  const auto [found, isNew] = numbers_.try_emplace(point, static_cast<std::int32_t>(points_.size()));
  if (isNew)
  {
    points_.push_back(point);
  }
  return found->second;
}

void SurfacePatch::addTriangle(std::uint8_t front, std::uint8_t back, const Corners& corners)
{
  if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
  {
    return;
  }
  if (front < back)
  {
    triangles_.push_back({ front, back, corners });
  }
  else
  {
    triangles_.push_back({ back, front, { corners[0], corners[2], corners[1] } });
  }
}

Interfaces joinPatches(const std::vector<SurfacePatch>& patches, Progress& progress)
{
  Interfaces result;
  const std::vector<std::vector<std::int32_t>> ids = unifyPoints(patches, result.points);
  std::map<std::pair<std::uint8_t, std::uint8_t>, std::vector<Corners>> surfaces;
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    progress.check();
    for (const SurfacePatch::Triangle& triangle : patches[p].triangles())
    {
      const Corners& c = triangle.corners;
      surfaces[{ triangle.positive, triangle.negative }].push_back(
        rotated({ ids[p][c[0]], ids[p][c[1]], ids[p][c[2]] }));
    }
  }
  for (auto& [pair, triangles] : surfaces)
  {
    progress.check();
    removeRepetitions(triangles);
    if (!triangles.empty())
    {
      result.surfaces.push_back({ MaterialId(pair.first), MaterialId(pair.second), std::move(triangles) });
    }
  }
  compact(result);
  return result;
}
}
