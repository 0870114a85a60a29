#include "Extract/UnmatchedFaces.h"

#include "Extract/ForEach.h"
#include "Geometry/Box.h"
#include "Model/MixedBits.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace strata
{
namespace
{
Index lowestCorner(const CellFaces& faces, std::int32_t f)
{
  return *std::min_element(faces.corners.begin() + faces.start[f], faces.corners.begin() + faces.start[f + 1]);
}

/// By point: combines the faces whose lowest corner it is. Two equal faces cancel, so that 0 says: all are matched.
std::vector<std::atomic<std::uint64_t>> sumFaces(const GridTopology& topology, Progress& progress)
{
  std::vector<std::atomic<std::uint64_t>> sums(static_cast<std::size_t>(topology.pointCount()));
  tbb::parallel_for(tbb::blocked_range<Index>(0, topology.cellCount(), 1024), [&](const auto& range) {
    progress.check();
    CellFaces faces;
    for (Index cell = range.begin(); cell < range.end(); ++cell)
    {
      if (topology.hidden(cell))
      {
        continue;
      }
      topology.faceCorners(cell, faces);
      for (std::int32_t f = 0; f < faces.count(); ++f)
      {
        std::uint64_t sum = 0;
        for (std::int32_t i = faces.start[f]; i < faces.start[f + 1]; ++i)
        {
          sum += mixedBits(static_cast<std::uint64_t>(faces.corners[i]));
        }
        sums[lowestCorner(faces, f)].fetch_xor(mixedBits(sum), std::memory_order_relaxed);
      }
    }
  });
  return sums;
}

Box boxRound(const GridTopology& topology)
{
  Box box;
  for (Index point = 0; point < topology.pointCount(); ++point)
  {
    box.add(topology.point(point));
  }
  return box;
}

bool inSide(const GridTopology& topology, const CellFaces& faces, std::int32_t f, const Box& box)
{
  const double tolerance = 1e-9 * box.diagonal();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double plane : { box.lower[axis], box.upper[axis] })
    {
      if (std::all_of(faces.corners.begin() + faces.start[f], faces.corners.begin() + faces.start[f + 1],
            [&](Index corner) { return std::abs(topology.point(corner)[axis] - plane) <= tolerance; }))
      {
        return true;
      }
    }
  }
  return false;
}

/// The unmatched faces of some cells.
class Search
{
public:
  Search(const GridTopology& topology, const std::vector<std::atomic<std::uint64_t>>& sums, const Box& box) :
    topology_(topology), sums_(sums), box_(box)
  {}

  void add(Index cell, std::vector<UnmatchedFace>& result)
  {
    topology_.corners(cell, corners_);
    if (std::none_of(corners_.begin(), corners_.end(), [this](Index corner) { return isOpen(corner); }))
    {
      return;
    }
    topology_.faceCorners(cell, faces_);
    bool any = false;
    for (std::int32_t f = 0; f < faces_.count(); ++f)
    {
      any = any || mayBeUnmatched(f);
    }
    if (!any)
    {
      return;
    }
    topology_.faces(cell, faces_);
    for (std::int32_t f = 0; f < faces_.count(); ++f)
    {
      if (faces_.neighbours[f] < 0 && mayBeUnmatched(f))
      {
        result.push_back({ cell, f });
      }
    }
  }

private:
  bool isOpen(Index corner) const { return sums_[corner].load(std::memory_order_relaxed) != 0; }
  bool mayBeUnmatched(std::int32_t f) const
  {
    return isOpen(lowestCorner(faces_, f)) && !inSide(topology_, faces_, f, box_);
  }

  const GridTopology& topology_;
  const std::vector<std::atomic<std::uint64_t>>& sums_;
  const Box& box_;
  CellFaces faces_;
  std::vector<Index> corners_;
};
}

std::vector<UnmatchedFace> findUnmatchedFaces(const GridTopology& topology, Progress& progress)
{
  const std::vector<std::atomic<std::uint64_t>> sums = sumFaces(topology, progress);
  const Box box = boxRound(topology);
  constexpr Index blockSize = 4096;
  const Index blockCount = (topology.cellCount() + blockSize - 1) / blockSize;
  std::vector<std::vector<UnmatchedFace>> blocks(static_cast<std::size_t>(blockCount));
  tbb::parallel_for(Index{ 0 }, blockCount, [&](Index b) {
    progress.check();
    Search search(topology, sums, box);
    for (Index cell = b * blockSize; cell < std::min((b + 1) * blockSize, topology.cellCount()); ++cell)
    {
      if (!topology.hidden(cell))
      {
        search.add(cell, blocks[b]);
      }
    }
  });
  std::vector<UnmatchedFace> result;
  for (const std::vector<UnmatchedFace>& block : blocks)
  {
    result.insert(result.end(), block.begin(), block.end());
  }
  return result;
}
}
