#include "Conversion/UnstructuredBuilder.h"

#include "Conversion/CheckCells.h"
#include "Conversion/CurvedDeviation.h"
#include "Conversion/LatticeOfBoxes.h"
#include "Conversion/Weld.h"

#include "Geometry/Box.h"

#include <vtkDataSetAttributes.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace strata::conversion
{
void UnstructuredBuilder::beginBlock(InputBlock block, std::vector<Vector> points)
{
  const Index cellEnd = blocks_.empty() ? 0 : blocks_.back().cellOffset + blocks_.back().cellCount;
  block.label = label_;
  block.cellOffset = cellEnd;
  block.pointOffset = grid_.pointCount();
  block.pointCount = static_cast<Index>(points.size());
  blocks_.push_back(std::move(block));
  if (grid_.points.empty())
  {
    grid_.points = std::move(points);
  }
  else
  {
    grid_.points.insert(grid_.points.end(), points.begin(), points.end());
    weld_ = true;
  }
  if (grid_.cornerOffsets.empty())
  {
    grid_.cornerOffsets.push_back(0);
  }
}

Index UnstructuredBuilder::global(Index source, Index point) const
{
  const InputBlock& block = blocks_.back();
  if (point < 0 || point >= block.pointCount)
  {
    std::ostringstream message;
    message << "Cell " << source << block.name << " uses point " << point << ", but the points are numbered 0 to "
            << block.pointCount - 1;
    throw InvalidInput(message.str());
  }
  return block.pointOffset + point;
}

void UnstructuredBuilder::checkPoints(Index source, const Index* points, Index pointCount) const
{
  std::for_each(points, points + pointCount, [&](Index point) { global(source, point); });
}

void UnstructuredBuilder::finishCell(CellShape shape, Index source)
{
  grid_.shapes.push_back(shape);
  grid_.cornerOffsets.push_back(static_cast<Index>(grid_.corners.size()));
  cellSource_.push_back(blocks_.back().cellOffset + source);
  if (!grid_.faceOffsets.empty())
  {
    grid_.faceOffsets.push_back(static_cast<Index>(grid_.faceStart.size()) - 1);
  }
}

void UnstructuredBuilder::add(const CellKind& kind, Index source, const Index* points, Index pointCount)
{
  if (pointCount < static_cast<Index>(kind.corners.size()))
  {
    std::ostringstream message;
    message << "Cell " << source << blocks_.back().name << " has " << pointCount << " points; its type needs "
            << kind.corners.size();
    throw InvalidInput(message.str());
  }
  if (kind.use == CellKind::Use::Prism)
  {
    std::vector<Index> faces;
    for (const std::vector<int>& face : kind.faces)
    {
      faces.push_back(static_cast<Index>(face.size()));
      for (const int corner : face)
      {
        faces.push_back(points[corner]);
      }
    }
    addPolyhedron(source, points, pointCount, faces.data(), static_cast<Index>(kind.faces.size()));
    return;
  }
  for (const int corner : kind.corners)
  {
    grid_.corners.push_back(global(source, points[corner]));
  }
  finishCell(kind.shape, source);
}

Index UnstructuredBuilder::blended(const NodeWeights& weights, const std::vector<Index>& nodes)
{
  if (weights.size() == 1)
  {
    return nodes[static_cast<std::size_t>(weights.front().first)];
  }
  BlendedPoint blend;
  for (const auto& [node, weight] : weights)
  {
    blend.emplace_back(nodes[static_cast<std::size_t>(node)], weight);
  }
  blends_.push_back(std::move(blend));
  // Its place in the list of points is known once all blocks' points are: till then, below 0.
  return -static_cast<Index>(blends_.size());
}

void UnstructuredBuilder::addCurved(
  const std::shared_ptr<const CurvedPattern>& pattern, Index source, const Index* points)
{
  CurvedCell cell{ pattern, {} };
  for (int node = 0; node < pattern->nodeCount; ++node)
  {
    cell.nodes.push_back(global(source, points[node]));
  }
  std::vector<Index> lattice;
  for (const NodeWeights& weights : pattern->points)
  {
    lattice.push_back(blended(weights, cell.nodes));
  }
  for (const CurvedPattern::Piece& piece : pattern->pieces)
  {
    for (const int corner : piece.corners)
    {
      grid_.corners.push_back(lattice[static_cast<std::size_t>(corner)]);
    }
    finishCell(piece.shape, source);
  }
  curved_.push_back(std::move(cell));
  weld_ = true;
}

void UnstructuredBuilder::resolveBlends(InputGrid& result)
{
  if (curved_.empty())
  {
    return;
  }
  const Index first = grid_.pointCount();
  for (Index& corner : grid_.corners)
  {
    corner = corner < 0 ? first - 1 - corner : corner;
  }
  for (const BlendedPoint& blend : blends_)
  {
    Vector place = Vector::Zero();
    for (const auto& [point, weight] : blend)
    {
      place += weight * grid_.points[static_cast<std::size_t>(point)];
    }
    grid_.points.push_back(place);
  }
  CurvedDeviation deviation(3);
  std::vector<double> places;
  for (const CurvedCell& cell : curved_)
  {
    places.clear();
    for (const Index node : cell.nodes)
    {
      const Vector& place = grid_.points[static_cast<std::size_t>(node)];
      places.insert(places.end(), place.begin(), place.end());
    }
    deviation.add(*cell.pattern, places);
  }
  result.placeDeviation = deviation.bound();
  result.cornerSource = grid_.corners;
  result.blends = std::move(blends_);
  result.curved = std::move(curved_);
}

void UnstructuredBuilder::addPolyhedron(
  Index source, const Index* points, Index pointCount, const Index* faces, Index faceCount)
{
  if (grid_.faceOffsets.empty())
  {
    grid_.faceOffsets.assign(grid_.shapes.size() + 1, 0);
    grid_.faceStart.push_back(0);
  }
  for (Index i = 0; i < pointCount; ++i)
  {
    grid_.corners.push_back(global(source, points[i]));
  }
  for (Index f = 0; f < faceCount; ++f)
  {
    const Index size = *faces++;
    for (Index i = 0; i < size; ++i)
    {
      grid_.faceCorners.push_back(global(source, *faces++));
    }
    grid_.faceStart.push_back(static_cast<Index>(grid_.faceCorners.size()));
  }
  finishCell(CellShape::Polyhedron, source);
}

void UnstructuredBuilder::checkFinite(const InputGrid& result) const
{
  for (Index cell = 0; cell < grid_.cellCount(); ++cell)
  {
    for (Index k = grid_.cornerOffsets[static_cast<std::size_t>(cell)];
         k < grid_.cornerOffsets[static_cast<std::size_t>(cell) + 1]; ++k)
    {
      const Vector& point = grid_.points[static_cast<std::size_t>(grid_.corners[static_cast<std::size_t>(k)])];
      if (!point.allFinite())
      {
        std::ostringstream message;
        message << "A point of " << describeCell(result, cell) << " is not finite: (" << point[0] << ", " << point[1]
                << ", " << point[2] << ")";
        throw InvalidInput(message.str());
      }
    }
  }
}

void UnstructuredBuilder::compactPoints(InputGrid& result)
{
  std::vector<Index> place(grid_.points.size(), -1);
  for (const Index corner : grid_.corners)
  {
    place[static_cast<std::size_t>(corner)] = 0;
  }
  // Only points that cells use: others may be anywhere, even not finite.
  std::vector<Vector> points;
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    if (place[i] == 0)
    {
      place[i] = static_cast<Index>(points.size());
      points.push_back(grid_.points[i]);
      result.pointSource.push_back(static_cast<Index>(i));
    }
  }
  if (weld_)
  {
    Box box;
    for (const Vector& point : points)
    {
      box.add(point);
    }
    const std::vector<Index> welded = weld(points, weldTolerance * box.diagonal());
    std::vector<Index> kept(points.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (welded[i] == static_cast<Index>(i))
      {
        kept[i] = static_cast<Index>(count);
        points[count] = points[i];
        result.pointSource[count++] = result.pointSource[i];
      }
      else
      {
        kept[i] = kept[static_cast<std::size_t>(welded[i])];
      }
    }
    points.resize(count);
    result.pointSource.resize(count);
    for (Index& p : place)
    {
      p = p < 0 ? p : kept[static_cast<std::size_t>(p)];
    }
  }
  for (std::vector<Index>* list : { &grid_.corners, &grid_.faceCorners })
  {
    for (Index& corner : *list)
    {
      corner = place[static_cast<std::size_t>(corner)];
    }
  }
  grid_.points = std::move(points);
}

void UnstructuredBuilder::warn(InputGrid& result) const
{
  if (ignored_ > 0)
  {
    result.warnings.push_back(
      std::to_string(ignored_) + " cells without volume (vertices, lines, surfaces) are ignored");
  }
  if (straightened_ > 0)
  {
    result.hasUnboundedCurves = true;
    result.warnings.push_back(
      std::to_string(straightened_) + " curved cells are taken as straight cells between their corners");
  }
  if (!result.curved.empty())
  {
    const bool bounded = std::all_of(result.curved.begin(), result.curved.end(),
      [](const CurvedCell& cell) { return !cell.pattern->deviation.empty(); });
    result.hasUnboundedCurves = result.hasUnboundedCurves || !bounded;
    std::ostringstream text;
    text << result.curved.size() << " curved cells are taken as linear ones between their nodes, which lie within "
         << result.placeDeviation << " of them"
         << (bounded ? "" : "; those of some types (pyramids, high degrees, rational weights) are not bounded");
    result.warnings.push_back(text.str());
  }
}

InputGrid UnstructuredBuilder::finish()
{
  InputGrid result;
  result.blocks = std::move(blocks_);
  result.cellSource = std::move(cellSource_);
  resolveBlends(result);
  warn(result);
  if (grid_.cellCount() == 0)
  {
    throw InvalidInput("The grid has no visible cells with a volume");
  }
  checkFinite(result);
  orientWedges(grid_);
  result.grid = std::move(grid_);
  CheckedVolumes volumes = dropCellsWithoutVolume(result);
  grid_ = std::move(std::get<UnstructuredGrid>(result.grid));
  compactPoints(result);
  result.grid = std::move(grid_);
  dropRepeatedCells(result, volumes);
  result.hasOutside = !fillsBox(std::get<UnstructuredGrid>(result.grid), volumes);
  if (!result.hasOutside)
  {
    recognizeLattice(result);
  }
  return result;
}
}
