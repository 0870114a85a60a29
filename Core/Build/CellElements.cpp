#include "Build/CellElements.h"

#include <algorithm>
#include <numeric>

namespace strata
{
namespace
{
/// Positions are asked for in blocks of this many samples.
constexpr Index blockSize = 256;
/// Boxes are not free to make.
constexpr Index boxBlockSize = 16;

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

void keepNativeCells(
  const Barycentric& cell, const CellElements& all, const NativeData& native, std::vector<std::uint32_t>& kept)
{
  std::array<Box, boxBlockSize> boxes;
  for (Index begin = 0; begin < all.nativeCellCount(); begin += boxBlockSize)
  {
    const Index count = std::min<Index>(boxBlockSize, all.nativeCellCount() - begin);
    native.nativeCellBoxes(all.nativeCells() + begin, count, boxes.data());
    for (Index i = 0; i < count; ++i)
    {
      if (mayMeet(cell, boxes[static_cast<std::size_t>(i)]))
      {
        kept.push_back(all.nativeCells()[begin + i]);
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
  // Most triangles have a corner inside, which takes no clipping to see.
  return std::any_of(triangle.begin(), triangle.end(), [&](const Vector& p) {
    return cell.contains(p, faceTolerance);
  }) || !ClippedTriangle(cell, triangle).empty();
}

bool mayMeet(const Barycentric& cell, const Box& box)
{
  const Vector slack = faceTolerance * cell.box.size();
  if (((box.lower - slack).array() > cell.box.upper.array()).any() ||
      ((box.upper + slack).array() < cell.box.lower.array()).any())
  {
    return false;
  }
  const Vector center = box.center();
  const Vector half = 0.5 * box.size();
  for (const LinearFunction& weight : cell.weights)
  {
    // The largest value of the weight in the box.
    if (weight(center) + weight.gradient.cwiseAbs().dot(half) < -faceTolerance)
    {
      return false;
    }
  }
  return true;
}

CellElements allElements(
  const NativeData& native, const InterfaceElements& interfaces, bool withNativeCells, Progress& progress)
{
  std::vector<std::uint32_t> ids;
  constexpr Index largeBlock = 65536;
  std::vector<SampleIndex> block(static_cast<std::size_t>(largeBlock));
  std::vector<MaterialSet> sets(static_cast<std::size_t>(largeBlock));
  for (Index begin = 0; begin < static_cast<Index>(native.sampleCount()); begin += largeBlock)
  {
    const Index count = std::min<Index>(largeBlock, native.sampleCount() - begin);
    std::iota(block.begin(), block.end(), static_cast<SampleIndex>(begin));
    native.materialsAt(block.data(), count, sets.data());
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
      if (!sets[i].empty())
      {
        ids.push_back(block[i]);
      }
    }
    progress.check();
  }
  CellElements all;
  all.sampleEnd = static_cast<std::uint32_t>(ids.size());
  const auto append = [&](std::size_t count) {
    ids.resize(ids.size() + count);
    std::iota(ids.end() - static_cast<std::ptrdiff_t>(count), ids.end(), 0u);
    return static_cast<std::uint32_t>(ids.size());
  };
  all.vertexEnd = append(interfaces.points.size());
  all.triangleEnd = append(interfaces.triangles.size());
  const NativeCellIndex cells = withNativeCells ? native.nativeCellCount() : 0;
  for (NativeCellIndex cell = 0; cell < cells; ++cell)
  {
    if (cell % largeBlock == 0)
    {
      progress.check();
    }
    if (!native.nativeCell(cell).materials.empty())
    {
      ids.push_back(cell);
    }
  }
  all.nativeCellEnd = static_cast<std::uint32_t>(ids.size());
  all.ids.reset(new std::uint32_t[ids.size()]);
  std::copy(ids.begin(), ids.end(), all.ids.get());
  return all;
}

CellElements united(const std::vector<const CellElements*>& parts)
{
  std::array<std::vector<std::uint32_t>, 4> kinds;
  for (const CellElements* part : parts)
  {
    kinds[0].insert(kinds[0].end(), part->samples(), part->samples() + part->sampleCount());
    kinds[1].insert(kinds[1].end(), part->vertices(), part->vertices() + part->vertexCount());
    kinds[2].insert(kinds[2].end(), part->triangles(), part->triangles() + part->triangleCount());
    kinds[3].insert(kinds[3].end(), part->nativeCells(), part->nativeCells() + part->nativeCellCount());
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
  result.nativeCellEnd = result.triangleEnd + static_cast<std::uint32_t>(kinds[3].size());
  result.ids.reset(new std::uint32_t[result.nativeCellEnd]);
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
  keepNativeCells(cell, all, native, kept);
  result.nativeCellEnd = static_cast<std::uint32_t>(kept.size());
  result.ids.reset(kept.empty() ? nullptr : new std::uint32_t[kept.size()]);
  std::copy(kept.begin(), kept.end(), result.ids.get());
  return result;
}
}
