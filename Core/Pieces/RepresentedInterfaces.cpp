#include "Geometry/RegionTetrahedra.h"
#include "Geometry/SharedPoints.h"
#include "Pieces/CellBlocks.h"
#include "Pieces/Pieces.h"

namespace strata
{
namespace
{
/// Interface triangles of some cells before their points are shared: three corners each.
struct InterfaceBlock
{
  struct Triangle
  {
    std::int32_t positive;
    std::int32_t negative;
    Index cell;
  };
  std::vector<Triangle> triangles;
  std::vector<PointUse> corners;
};

void addTriangles(const TetrahedronCut& cut, const TetrahedronCut::Face& face, Index cell, InterfaceBlock& result)
{
  const int size = face.end - face.begin;
  const int centre = fanCentre(cut, face) - face.begin;
  const auto around = [&](int i) -> PointUse {
    return { cut.points()[cut.loops()[face.begin + (centre + i) % size]], 0 };
  };
  for (int i = 1; i + 1 < size; ++i)
  {
    // The face's normal points into the higher material; the triangle's into the lower one.
    result.triangles.push_back({ face.function, face.beyond, cell });
    result.corners.push_back(around(0));
    result.corners.push_back(around(i + 1));
    result.corners.push_back(around(i));
  }
}

void addInterfaces(const Representation& representation, Index cell, CutWorkspace& workspace, InterfaceBlock& result)
{
  distancesOfCell(representation, cell, workspace.distances);
  if (workspace.distances.size() < 2)
  {
    return;
  }
  workspace.cut.cut(
    verticesOfCell(representation, cell), workspace.distances.data(), static_cast<int>(workspace.distances.size()));
  for (const TetrahedronCut::Face& face : workspace.cut.faces())
  {
    if (face.isInterface())
    {
      addTriangles(workspace.cut, face, cell, result);
    }
  }
}

InterfaceBlock join(const std::vector<InterfaceBlock>& blocks)
{
  InterfaceBlock result;
  for (const InterfaceBlock& block : blocks)
  {
    result.triangles.insert(result.triangles.end(), block.triangles.begin(), block.triangles.end());
    result.corners.insert(result.corners.end(), block.corners.begin(), block.corners.end());
  }
  return result;
}

void writeTriangles(const InterfaceBlock& all, const SharedPoints& shared, RepresentedSurfaces& result)
{
  const Index count = static_cast<Index>(all.triangles.size());
  result.triangles = Buffer<std::int64_t>(3 * count);
  result.positive = Buffer<std::int32_t>(count);
  result.negative = Buffer<std::int32_t>(count);
  result.cell = Buffer<std::int64_t>(count);
  std::copy(shared.numbers.begin(), shared.numbers.end(), result.triangles.begin());
  for (Index triangle = 0; triangle < count; ++triangle)
  {
    result.positive[triangle] = all.triangles[triangle].positive;
    result.negative[triangle] = all.triangles[triangle].negative;
    result.cell[triangle] = all.triangles[triangle].cell;
  }
}

void writeValues(const Representation& representation, const InterfaceBlock& all, RepresentedSurfaces& result)
{
  const Index count = static_cast<Index>(all.corners.size());
  for (std::size_t field = 0; field < representation.fields.size(); ++field)
  {
    const int components = representation.fields[field].components;
    result.positiveValues.emplace_back(components * count);
    result.negativeValues.emplace_back(components * count);
    tbb::parallel_for(tbb::blocked_range<Index>(0, count, 4096), [&](const tbb::blocked_range<Index>& range) {
      for (Index corner = range.begin(); corner != range.end(); ++corner)
      {
        const InterfaceBlock::Triangle& triangle = all.triangles[corner / 3];
        const CutPoint& point = all.corners[corner].point;
        const std::vector<const float*>& values = representation.values[field];
        interpolateField(
          values[triangle.positive], components, point, &result.positiveValues.back()[components * corner]);
        interpolateField(
          values[triangle.negative], components, point, &result.negativeValues.back()[components * corner]);
      }
    });
  }
}
}

RepresentedSurfaces representedInterfaces(const Representation& representation, Progress& progress)
{
  const InterfaceBlock all = join(forCellBlocks<InterfaceBlock>(
    representation.cellCount, progress, [&](Index cell, CutWorkspace& workspace, InterfaceBlock& block) {
      addInterfaces(representation, cell, workspace, block);
    }));
  progress.update(0.6);
  const SharedPoints shared = sharePoints(all.corners);
  progress.check();
  RepresentedSurfaces result;
  result.points = Buffer<double>(3 * static_cast<Index>(shared.firstUse.size()));
  for (std::size_t point = 0; point < shared.firstUse.size(); ++point)
  {
    interpolatePosition(
      representation, all.corners[shared.firstUse[point]].point, &result.points[3 * static_cast<Index>(point)]);
  }
  writeTriangles(all, shared, result);
  writeValues(representation, all, result);
  progress.update(1.0);
  return result;
}
}
