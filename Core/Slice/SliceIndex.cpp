#include "Slice/SliceIndex.h"

#include "Slice/PlaneFunction.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<Index>;
constexpr Index grain = 4096;

/// A cell and its place on the curve.
struct Place
{
  std::uint64_t code;
  std::int32_t cell;
};

/// Spreads the lowest 21 bits so that two zeros follow each.
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001F00000000FFFFull;
  bits = (bits | bits << 16) & 0x001F0000FF0000FFull;
  bits = (bits | bits << 8) & 0x100F00F00F00F00Full;
  bits = (bits | bits << 4) & 0x10C30C30C30C30C3ull;
  return (bits | bits << 2) & 0x1249249249249249ull;
}

std::uint64_t codeOf(const Vector& point, const Box& box)
{
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = box.upper[axis] - box.lower[axis];
    const double part = size > 0.0 ? (point[axis] - box.lower[axis]) / size : 0.0;
    code |= spread(static_cast<std::uint64_t>(std::clamp(part, 0.0, 1.0) * 2097151.0)) << axis;
  }
  return code;
}

Box boxOfPoints(const Representation& representation)
{
  Box box;
  for (Index vertex = 0; vertex < representation.vertexCount; ++vertex)
  {
    box.add(representation.point(vertex));
  }
  return box;
}

bool meets(const Representation& representation, const PlaneFunction& function, Index cell)
{
  int positives = 0;
  int negatives = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double value = function(representation, representation.tetrahedra[4 * cell + corner]);
    positives += value > 0.0 ? 1 : 0;
    negatives += value < 0.0 ? 1 : 0;
  }
  return positives < 4 && negatives < 4;
}
}

SliceIndex::SliceIndex(const Representation& representation, Progress& progress)
{
  const Index count = representation.cellCount;
  const Box box = boxOfPoints(representation);
  std::vector<Place> places(static_cast<std::size_t>(count));
  tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
    progress.check();
    for (Index cell = range.begin(); cell != range.end(); ++cell)
    {
      Vector sum = Vector::Zero();
      for (int corner = 0; corner < 4; ++corner)
      {
        sum += representation.point(representation.tetrahedra[4 * cell + corner]);
      }
      places[cell] = { codeOf(0.25 * sum, box), static_cast<std::int32_t>(cell) };
    }
  });
  tbb::parallel_sort(places.begin(), places.end(),
    [](const Place& a, const Place& b) { return a.code != b.code ? a.code < b.code : a.cell < b.cell; });
  progress.check();
  order_.resize(places.size());
  boxes_.resize(static_cast<std::size_t>((count + cellsPerGroup - 1) / cellsPerGroup));
  tbb::parallel_for(Range(0, static_cast<Index>(boxes_.size()), grain / cellsPerGroup), [&](const Range& range) {
    for (Index i = groupStart(range.begin()); i < groupStart(range.end()); ++i)
    {
      order_[i] = places[i].cell;
      for (int corner = 0; corner < 4; ++corner)
      {
        boxes_[i / cellsPerGroup].add(representation.point(representation.tetrahedra[4 * Index(order_[i]) + corner]));
      }
    }
  });
}

std::vector<Index> SliceIndex::cellsAt(const Representation& representation, const SlicePlane& plane) const
{
  const PlaneFunction function(plane);
  tbb::enumerable_thread_specific<std::vector<Index>> found;
  tbb::parallel_for(Range(0, static_cast<Index>(boxes_.size()), 256), [&](const Range& range) {
    std::vector<Index>& cells = found.local();
    for (Index group = range.begin(); group != range.end(); ++group)
    {
      double lower;
      double upper;
      function.range(boxes_[group], lower, upper);
      const Index last = lower <= 0.0 && upper >= 0.0 ? groupStart(group + 1) : 0;
      for (Index i = groupStart(group); i < last; ++i)
      {
        if (meets(representation, function, order_[i]))
        {
          cells.push_back(order_[i]);
        }
      }
    }
  });
  std::vector<Index> result;
  for (const std::vector<Index>& cells : found)
  {
    result.insert(result.end(), cells.begin(), cells.end());
  }
  tbb::parallel_sort(result.begin(), result.end());
  return result;
}

bool SliceIndex::reachesBelow(const Representation& representation, const SlicePlane& plane) const
{
  const PlaneFunction function(plane);
  for (std::size_t group = 0; group < boxes_.size(); ++group)
  {
    double lower;
    double upper;
    function.range(boxes_[group], lower, upper);
    const Index last = groupStart(static_cast<Index>(group) + 1);
    for (Index i = groupStart(static_cast<Index>(group)); upper >= 0.0 && lower <= 0.0 && i < last; ++i)
    {
      const std::int64_t* corners = representation.tetrahedra + 4 * Index(order_[i]);
      if (std::any_of(corners, corners + 4, [&](std::int64_t v) { return function(representation, v) < 0.0; }))
      {
        return true;
      }
    }
    if (upper < 0.0)
    {
      return true;
    }
  }
  return false;
}
}
