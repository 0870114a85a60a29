#include "Build/CellElements.h"

#include <algorithm>

namespace strata
{
namespace
{
/// A triangle clipped by four half-spaces has at most seven corners; rounding may add a few.
using Polygon = std::array<Vector, 16>;

std::size_t clip(Polygon& polygon, std::size_t count, const LinearFunction& weight)
{
  Polygon kept;
  std::size_t size = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % count];
    const double wa = weight(a) + faceTolerance;
    const double wb = weight(b) + faceTolerance;
    if (wa >= 0.0)
    {
      kept[size++] = a;
    }
    if ((wa >= 0.0) != (wb >= 0.0))
    {
      kept[size++] = a + (b - a) * (wa / (wa - wb));
    }
  }
  polygon = kept;
  return size;
}

/// Positions are asked for in blocks of this many samples.
constexpr Index blockSize = 256;

void keepSamples(
  const Barycentric& cell, const CellElements& all, const NativeData& native, std::vector<std::uint32_t>& kept)
{
  std::array<Vector, blockSize> positions;
  for (Index begin = 0; begin < all.sampleCount(); begin += blockSize)
  {
    const Index count = std::min<Index>(blockSize, all.sampleCount() - begin);
    native.positions(all.samples() + begin, count, positions.data());
    for (Index i = 0; i < count; ++i)
    {
      if (cell.contains(positions[static_cast<std::size_t>(i)], faceTolerance))
      {
        kept.push_back(all.samples()[begin + i]);
      }
    }
  }
}
}

InterfaceElements::InterfaceElements(const Interfaces& interfaces) : points(interfaces.points)
{
  std::vector<std::vector<std::int32_t>> pairsAt(points.size());
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    const auto pair = static_cast<std::int32_t>(pairs.size());
    pairs.push_back({ surface.positive, surface.negative });
    for (const std::array<std::int32_t, 3>& triangle : surface.triangles)
    {
      triangles.push_back(triangle);
      pairOfTriangle.push_back(pair);
      for (const std::int32_t corner : triangle)
      {
        std::vector<std::int32_t>& known = pairsAt[static_cast<std::size_t>(corner)];
        if (std::find(known.begin(), known.end(), pair) == known.end())
        {
          known.push_back(pair);
        }
      }
    }
  }
  vertexPairOffsets.push_back(0);
  for (const std::vector<std::int32_t>& known : pairsAt)
  {
    vertexPairs.insert(vertexPairs.end(), known.begin(), known.end());
    vertexPairOffsets.push_back(static_cast<std::int32_t>(vertexPairs.size()));
  }
}

MaterialSet InterfaceElements::materialsOfTriangle(std::uint32_t triangle) const
{
  const Pair& pair = pairs[static_cast<std::size_t>(pairOfTriangle[triangle])];
  return MaterialSet::of(pair.positive) | MaterialSet::of(pair.negative);
}

MaterialSet InterfaceElements::materialsOfVertex(std::uint32_t vertex) const
{
  MaterialSet result;
  for (std::int32_t i = vertexPairOffsets[vertex]; i < vertexPairOffsets[vertex + 1]; ++i)
  {
    const Pair& pair = pairs[static_cast<std::size_t>(vertexPairs[static_cast<std::size_t>(i)])];
    result.insert(pair.positive);
    result.insert(pair.negative);
  }
  return result;
}

bool meets(const Barycentric& cell, const std::array<Vector, 3>& triangle)
{
  // Most triangles have a corner inside, or lie beyond one face.
  std::array<bool, 3> inside = { true, true, true };
  for (const LinearFunction& weight : cell.weights)
  {
    bool beyond = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const bool within = weight(triangle[i]) >= -faceTolerance;
      inside[i] = inside[i] && within;
      beyond = beyond && !within;
    }
    if (beyond)
    {
      return false;
    }
  }
  if (inside[0] || inside[1] || inside[2])
  {
    return true;
  }
  Polygon polygon;
  std::copy(triangle.begin(), triangle.end(), polygon.begin());
  std::size_t count = 3;
  for (const LinearFunction& weight : cell.weights)
  {
    count = clip(polygon, count, weight);
    if (count == 0)
    {
      return false;
    }
  }
  return true;
}

CellElements united(const std::vector<const CellElements*>& parts)
{
  std::array<std::vector<std::uint32_t>, 3> kinds;
  for (const CellElements* part : parts)
  {
    kinds[0].insert(kinds[0].end(), part->samples(), part->samples() + part->sampleCount());
    kinds[1].insert(kinds[1].end(), part->vertices(), part->vertices() + part->vertexCount());
    kinds[2].insert(kinds[2].end(), part->triangles(), part->triangles() + part->triangleCount());
  }
  for (std::vector<std::uint32_t>& ids : kinds)
  {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }
  CellElements result;
  result.sampleEnd = static_cast<std::uint32_t>(kinds[0].size());
  result.vertexEnd = result.sampleEnd + static_cast<std::uint32_t>(kinds[1].size());
  result.triangleEnd = result.vertexEnd + static_cast<std::uint32_t>(kinds[2].size());
  result.ids.reset(new std::uint32_t[result.triangleEnd]);
  std::uint32_t* next = result.ids.get();
  for (const std::vector<std::uint32_t>& ids : kinds)
  {
    next = std::copy(ids.begin(), ids.end(), next);
  }
  return result;
}

CellElements elementsWithin(
  const Barycentric& cell, const CellElements& all, const NativeData& native, const InterfaceElements& interfaces)
{
  std::vector<std::uint32_t> kept;
  CellElements result;
  keepSamples(cell, all, native, kept);
  result.sampleEnd = static_cast<std::uint32_t>(kept.size());
  for (std::uint32_t i = 0; i < all.vertexCount(); ++i)
  {
    if (cell.contains(interfaces.points[all.vertices()[i]], faceTolerance))
    {
      kept.push_back(all.vertices()[i]);
    }
  }
  result.vertexEnd = static_cast<std::uint32_t>(kept.size());
  for (std::uint32_t i = 0; i < all.triangleCount(); ++i)
  {
    const auto& [a, b, c] = interfaces.triangles[all.triangles()[i]];
    if (meets(cell, { interfaces.points[a], interfaces.points[b], interfaces.points[c] }))
    {
      kept.push_back(all.triangles()[i]);
    }
  }
  result.triangleEnd = static_cast<std::uint32_t>(kept.size());
  result.ids.reset(kept.empty() ? nullptr : new std::uint32_t[kept.size()]);
  std::copy(kept.begin(), kept.end(), result.ids.get());
  return result;
}
}
