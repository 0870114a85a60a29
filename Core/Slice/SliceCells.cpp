#include "Slice/SliceCells.h"

#include "Geometry/CutPolygon.h"
#include "Model/CellDistances.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<Index>;
/// Cells per task; results are joined in the order of the tasks' cells. Small, so that a task's results grow in the
/// processor's cache: an index passes only cells that are cut.
constexpr Index cellsPerBlock = 2048;
constexpr Index cutCellsPerBlock = 128;

/// What a thread needs to cut cells.
struct Workspace
{
  PolygonCut cut;
  std::vector<CornerValues> distances;
};

/// The plane's values at the vertices, and which side their zeros belong to.
class SignedPlane
{
public:
  SignedPlane(
    const Representation& representation, const SlicePlane& plane, const SliceIndex* index, Progress& progress) :
    representation_(representation),
    function_(plane)
  {
    if (index)
    {
      turned_ = !index->reachesBelow(representation, plane);
      return;
    }
    values_.resize(static_cast<std::size_t>(representation.vertexCount));
    std::atomic<bool> reachesBelow{ false };
    tbb::parallel_for(Range(0, representation.vertexCount, cellsPerBlock), [&](const Range& range) {
      progress.check();
      bool below = false;
      for (Index vertex = range.begin(); vertex != range.end(); ++vertex)
      {
        values_[vertex] = function_(representation, vertex);
        below = below || values_[vertex] < 0.0;
      }
      if (below)
      {
        reachesBelow = true;
      }
    });
    turned_ = !reachesBelow;
  }

  /// True if no vertex is negative: then zeros count as negative, so that the plane of a boundary face shows it.
  bool turned() const { return turned_; }
  /// Values at a cell's corners, negated if turned. Returns whether the plane cuts the cell.
  bool cuts(const std::array<std::int64_t, 4>& vertices, std::array<double, 4>& values) const
  {
    int positives = 0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double value = values_.empty() ? function_(representation_, vertices[corner]) : values_[vertices[corner]];
      values[corner] = turned_ ? -value : value;
      positives += values[corner] >= 0.0 ? 1 : 0;
    }
    return positives > 0 && positives < 4;
  }

private:
  const Representation& representation_;
  PlaneFunction function_;
  std::vector<double> values_;
  bool turned_ = false;
};

void sliceCell(const Representation& representation, const SignedPlane& plane, MaterialSet materials, Index cell,
  Workspace& workspace, PolygonUses& result)
{
  const std::array<std::int64_t, 4> vertices = verticesOfCell(representation, cell);
  std::array<double, 4> planeValues;
  if (!plane.cuts(vertices, planeValues))
  {
    return;
  }
  distancesOfCell(representation, cell, workspace.distances);
  PolygonCut& cut = workspace.cut;
  cut.cutSection(vertices, planeValues, workspace.distances.data(), static_cast<int>(workspace.distances.size()));
  for (const PolygonCut::Region& region : cut.regions())
  {
    if (!materials.contains(MaterialId(region.function)))
    {
      continue;
    }
    const std::size_t begin = result.corners.size();
    for (int i = region.begin; i < region.end; ++i)
    {
      result.corners.push_back({ cut.points()[cut.loops()[i]], region.function });
    }
    if (plane.turned())
    {
      std::reverse(result.corners.begin() + static_cast<std::ptrdiff_t>(begin), result.corners.end());
    }
    result.ends.push_back(static_cast<std::int64_t>(result.corners.size()));
    result.material.push_back(region.function);
    result.cell.push_back(cell);
  }
}
}

PolygonUses sliceCells(const Representation& representation, const SlicePlane& plane, MaterialSet materials,
  const SliceIndex* index, Progress& progress)
{
  const SignedPlane signedPlane(representation, plane, index, progress);
  const std::vector<Index> near = index ? index->cellsAt(representation, plane) : std::vector<Index>();
  const Index count = index ? static_cast<Index>(near.size()) : representation.cellCount;
  const Index blockSize = index ? cutCellsPerBlock : cellsPerBlock;
  const Index blockCount = (count + blockSize - 1) / blockSize;
  std::vector<PolygonUses> blocks(static_cast<std::size_t>(blockCount));
  tbb::enumerable_thread_specific<Workspace> workspaces;
  tbb::parallel_for(Range(0, blockCount, 1), [&](const Range& range) {
    Workspace& workspace = workspaces.local();
    for (Index block = range.begin(); block != range.end(); ++block)
    {
      progress.check();
      for (Index i = block * blockSize; i < std::min(count, (block + 1) * blockSize); ++i)
      {
        sliceCell(representation, signedPlane, materials, index ? near[i] : i, workspace, blocks[block]);
      }
    }
  });
  progress.update(0.7);
  return joinPolygons(blocks);
}
}
