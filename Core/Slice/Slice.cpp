#include "Slice/Slice.h"

#include "Geometry/SharedPoints.h"
#include "Model/CellDistances.h"
#include "Slice/SliceCells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<Index>;
constexpr Index grain = 2048;

void checkInput(const Representation& representation, const SlicePlane& plane, const SliceIndex* index)
{
  if (!plane.normal.allFinite() || plane.normal.isZero(0.0))
  {
    throw InvalidInput("the normal of the slice plane is (" + std::to_string(plane.normal[0]) + ", " +
                       std::to_string(plane.normal[1]) + ", " + std::to_string(plane.normal[2]) +
                       "): it has no direction");
  }
  if (!plane.origin.allFinite() || !std::isfinite(plane.offset))
  {
    throw InvalidInput("the origin or the offset of the slice plane is not finite");
  }
  if (index && index->cellCount() != representation.cellCount)
  {
    throw InvalidInput("the slice index was made for " + std::to_string(index->cellCount()) + " cells, not for " +
                       std::to_string(representation.cellCount));
  }
}

template<typename T>
Buffer<T> bufferOf(const std::vector<T>& values)
{
  Buffer<T> result(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

void writePoints(const Representation& representation, const std::vector<PointUse>& uses, const SharedPoints& shared,
  SlicePolygons& result)
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
        const float* values = representation.values[field][static_cast<std::size_t>(use.owner)];
        interpolateField(values, components, use.point, &result.values[field][components * point]);
      }
    }
  });
}
}

SlicePolygons slice(const Representation& representation, const SlicePlane& plane, MaterialSet materials,
  const SliceIndex* index, Progress& progress)
{
  checkInput(representation, plane, index);
  const SlicedCells cells = sliceCells(representation, plane, materials, index, progress);
  const SharedPoints shared = sharePoints(cells.corners);
  progress.check();
  SlicePolygons result;
  result.corners = bufferOf(shared.numbers);
  result.offsets = Buffer<std::int64_t>(static_cast<Index>(cells.ends.size()) + 1);
  result.offsets[0] = 0;
  std::copy(cells.ends.begin(), cells.ends.end(), result.offsets.begin() + 1);
  result.material = bufferOf(cells.material);
  result.tetrahedron = bufferOf(cells.cell);
  writePoints(representation, cells.corners, shared, result);
  progress.update(1.0);
  return result;
}
}
