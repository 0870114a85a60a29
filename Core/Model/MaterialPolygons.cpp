#include "Model/MaterialPolygons.h"

#include "Model/CellDistances.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<Index>;
constexpr Index grain = 2048;

template<typename T>
Buffer<T> bufferOf(const std::vector<T>& values)
{
  Buffer<T> result(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

void writePoints(const Representation& representation, const std::vector<PointUse>& uses, const SharedPoints& shared,
  MaterialPolygons& result)
{
  const Index count = static_cast<Index>(shared.firstUse.size());
  result.points = Buffer<double>(3 * count);
  for (const Field& field : representation.fields)
  {
    result.values.emplace_back(field.components * count);
  }
  tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
    for (Index point = range.begin(); point != range.end(); ++point)
    {
      const PointUse& use = uses[shared.firstUse[point]];
      interpolatePosition(representation, use.point, &result.points[3 * point]);
      for (std::size_t field = 0; field < representation.fields.size(); ++field)
      {
        const int components = representation.fields[field].components;
        const float* values = representation.values[field][static_cast<std::size_t>(use.owner % MaterialSet::capacity)];
        interpolateField(values, components, use.point, &result.values[field][components * point]);
      }
    }
  });
}
}

PolygonUses joinPolygons(const std::vector<PolygonUses>& blocks)
{
  std::vector<std::size_t> firstCorner(1, 0);
  std::vector<std::size_t> firstPolygon(1, 0);
  for (const PolygonUses& block : blocks)
  {
    firstCorner.push_back(firstCorner.back() + block.corners.size());
    firstPolygon.push_back(firstPolygon.back() + block.ends.size());
  }
  PolygonUses result;
  result.corners.resize(firstCorner.back());
  result.ends.resize(firstPolygon.back());
  result.material.resize(firstPolygon.back());
  result.cell.resize(firstPolygon.back());
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(), [&](std::size_t b) {
    const PolygonUses& block = blocks[b];
    const std::size_t polygon = firstPolygon[b];
    std::copy(block.corners.begin(), block.corners.end(), result.corners.begin() + firstCorner[b]);
    std::copy(block.material.begin(), block.material.end(), result.material.begin() + polygon);
    std::copy(block.cell.begin(), block.cell.end(), result.cell.begin() + polygon);
    for (std::size_t i = 0; i < block.ends.size(); ++i)
    {
      result.ends[polygon + i] = block.ends[i] + static_cast<std::int64_t>(firstCorner[b]);
    }
  });
  return result;
}

MaterialPolygons sharePolygons(const Representation& representation, const PolygonUses& uses)
{
  const SharedPoints shared = sharePoints(uses.corners);
  MaterialPolygons result;
  result.corners = bufferOf(shared.numbers);
  result.offsets = Buffer<std::int64_t>(static_cast<Index>(uses.ends.size()) + 1);
  result.offsets[0] = 0;
  std::copy(uses.ends.begin(), uses.ends.end(), result.offsets.begin() + 1);
  result.material = bufferOf(uses.material);
  result.tetrahedron = bufferOf(uses.cell);
  writePoints(representation, uses.corners, shared, result);
  return result;
}
}
