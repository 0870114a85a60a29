#include "InterfaceCertificate.h"

#include "Certify/PieceDistance.h"
#include "Certify/RepresentedPieces.h"
#include "CloseRegions.h"
#include "Emit/Emit.h"
#include "Model/CellDistances.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// Longest edges, in units of the bound: of cells smaller than this only some are split, and none below the smallest.
/// Else a sheet without thickness, which no cell is small enough to show, would take millions.
constexpr double smallCell = 1.0 / 4.0;
constexpr double smallestCell = 1.0 / 32.0;
/// As many small cells are split as this part of the cells of the first level measured.
constexpr double smallSplits = 1.0 / 8.0;

double longestEdge(const Hierarchy& hierarchy, CellId cell)
{
  const std::array<VertexId, 4>& corners = hierarchy.cell(cell).corners;
  double longest = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      longest = std::max(longest, (hierarchy.position(corners[i]) - hierarchy.position(corners[j])).norm());
    }
  }
  return longest;
}

bool same(const std::vector<CornerValues>& a, const std::vector<CornerValues>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const CornerValues& x, const CornerValues& y) { return x.function == y.function && x.values == y.values; });
}

double largestCoordinate(const Box& box)
{
  return std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
}
}

InterfaceCertificate::InterfaceCertificate(
  const HierarchyBuilder& builder, const InterfaceTrees& original, Criterion criterion) :
  builder_(builder),
  original_(original), criterion_(std::move(criterion)),
  rounding_(distanceRounding(largestCoordinate(builder.hierarchy().lattice.box)))
{}

void InterfaceCertificate::measure(const Hierarchy& values, Level& level, Progress& progress)
{
  const InterfaceTrees gone = updatePieces(values, level, progress);
  std::vector<const std::vector<InterfacePiece>*> pieces;
  for (const CellId cell : cells_)
  {
    pieces.push_back(&recordOf(cell).represented);
  }
  represented_ = std::make_unique<InterfaceTrees>(pieces);
  tbb::parallel_for(std::size_t{ 0 }, cells_.size(), [&](std::size_t i) {
    Record& record = recordOf(cells_[i]);
    const bool lostSupport = !record.isNew && mayHaveSupported(gone, record);
    if (record.changed || lostSupport)
    {
      progress.check();
    }
    if (record.changed)
    {
      record.representedError = largestDistance(record.represented, original_, record.limit, rounding_);
    }
    if (record.isNew || lostSupport)
    {
      record.originalError = largestDistance(record.original, *represented_, record.limit, rounding_);
    }
  });
}

bool InterfaceCertificate::mayHaveSupported(const InterfaceTrees& surfaces, const Record& record)
{
  // What is farther than the error counted for no point of the pieces.
  const double reach = record.radius + std::min(record.limit, record.originalError);
  UnorderedPair last;
  for (const InterfacePiece& piece : record.original)
  {
    const TriangleTree* surface = surfaces.between(piece.materials);
    const bool isNext = last < piece.materials || piece.materials < last;
    last = piece.materials;
    if (surface && isNext && surface->closest(record.center, reach * reach).triangle >= 0)
    {
      return true;
    }
  }
  return false;
}

void InterfaceCertificate::complete(Progress& progress)
{
  tbb::parallel_for(std::size_t{ 0 }, cells_.size(), [&](std::size_t i) {
    progress.check();
    Record& record = recordOf(cells_[i]);
    const double limit = record.limit;
    while (record.error() > record.limit && std::isfinite(record.error()))
    {
      record.limit = 2.0 * record.error();
      record.representedError = largestDistance(record.represented, original_, record.limit, rounding_);
      record.originalError = largestDistance(record.original, *represented_, record.limit, rounding_);
    }
    record.limit = limit;
  });
  regionError_ = regionDistance(progress);
}

double InterfaceCertificate::regionDistance(Progress& progress)
{
  double largest = 0.0;
  std::vector<const Record*> withoutCounterpart;
  for (const CellId cell : cells_)
  {
    const Record& record = recordOf(cell);
    if (std::isfinite(record.error()))
    {
      largest = std::max(largest, record.error());
    }
    else
    {
      withoutCounterpart.push_back(&record);
    }
  }
  if (withoutCounterpart.empty())
  {
    return largest;
  }
  const RegionTrees original(original_);
  const RegionTrees represented(*represented_);
  std::vector<double> distances(withoutCounterpart.size());
  tbb::parallel_for(std::size_t{ 0 }, distances.size(), [&](std::size_t i) {
    progress.check();
    distances[i] = regionDistance(*withoutCounterpart[i], original, represented);
  });
  return std::max(largest, *std::max_element(distances.begin(), distances.end()));
}

double InterfaceCertificate::regionDistance(
  const Record& record, const RegionTrees& original, const RegionTrees& represented) const
{
  for (double limit = record.limit;;)
  {
    const double distance = std::max(largestDistanceToRegions(record.represented, original, limit, rounding_),
      largestDistanceToRegions(record.original, represented, limit, rounding_));
    if (distance <= limit || !std::isfinite(distance))
    {
      return distance;
    }
    limit = 2.0 * distance;
  }
}

InterfaceTrees InterfaceCertificate::updatePieces(const Hierarchy& values, Level& level, Progress& progress)
{
  EmitOptions distancesOnly;
  distancesOnly.perMaterialValues = false;
  distancesOnly.ghosts = false;
  LevelCells cells = levelCells(values, level, progress);
  closeRegions(builder_, values, level, cells, progress);
  const std::vector<CellId> before = std::move(cells_);
  cells_ = cells.cells;
  if (before.empty())
  {
    smallSplitsLeft_ = static_cast<std::size_t>(smallSplits * static_cast<double>(cells_.size()));
  }
  const Mesh mesh = emitMesh(values, level, std::move(cells), distancesOnly, progress);
  const Representation representation = view(mesh);
  records_.resize(values.cells.size());
  tbb::enumerable_thread_specific<TetrahedronCut> cuts;
  tbb::parallel_for(std::size_t{ 0 }, cells_.size(), [&](std::size_t i) {
    progress.check();
    updatePieces(values, representation, static_cast<Index>(i), cuts.local());
  });
  std::vector<const std::vector<InterfacePiece>*> gone;
  for (const CellId cell : before)
  {
    const Record& record = recordOf(cell);
    const bool isSplit = level.isActive(values.cell(cell).diamond);
    gone.push_back(isSplit ? &record.represented : &record.gone);
  }
  return InterfaceTrees(gone);
}

void InterfaceCertificate::updatePieces(
  const Hierarchy& values, const Representation& mesh, Index number, TetrahedronCut& cut)
{
  const CellId cell = cells_[static_cast<std::size_t>(number)];
  std::unique_ptr<Record>& record = records_[static_cast<std::size_t>(cell.value)];
  std::vector<CornerValues> distances;
  distancesOfCell(mesh, number, distances);
  const bool isNew = !record;
  if (isNew)
  {
    record = newRecord(values, cell);
  }
  record->isNew = isNew;
  record->changed = isNew || !same(record->distances, distances);
  record->gone.clear();
  if (record->changed)
  {
    record->gone = std::move(record->represented);
    record->represented = representedPieces(mesh, number, cut);
    record->distances = std::move(distances);
  }
}

std::unique_ptr<InterfaceCertificate::Record> InterfaceCertificate::newRecord(
  const Hierarchy& values, CellId cell) const
{
  auto record = std::make_unique<Record>();
  record->original = builder_.interfacePieces(cell);
  record->limit = criterion_.interfaceBound(values, cell);
  Box box;
  for (const InterfacePiece& piece : record->original)
  {
    std::for_each(piece.corners.begin(), piece.corners.end(), [&](const Vector& p) { box.add(p); });
  }
  record->center = box.center();
  record->radius = 0.5 * box.diagonal();
  return record;
}

std::vector<CellId> InterfaceCertificate::tooCoarse(const Hierarchy& values)
{
  std::vector<CellId> result;
  std::vector<CellId> small;
  for (const CellId cell : cells_)
  {
    if (exceedsBound(cell) && criterion_.maySplit(values.cell(cell)))
    {
      const double size = longestEdge(values, cell) / recordOf(cell).limit;
      if (size > smallestCell)
      {
        (size > smallCell ? result : small).push_back(cell);
      }
    }
  }
  if (small.size() <= smallSplitsLeft_)
  {
    smallSplitsLeft_ -= small.size();
    result.insert(result.end(), small.begin(), small.end());
  }
  return result;
}

bool InterfaceCertificate::boundsHold() const
{
  return std::none_of(cells_.begin(), cells_.end(), [&](CellId cell) { return exceedsBound(cell); });
}

bool InterfaceCertificate::leavesThinParts(const Hierarchy& values) const
{
  return std::any_of(cells_.begin(), cells_.end(),
    [&](CellId cell) { return exceedsBound(cell) && criterion_.maySplit(values.cell(cell)); });
}

void InterfaceCertificate::writeErrors(Mesh& mesh) const
{
  float largest = 0.0f;
  for (std::size_t i = 0; i < cells_.size(); ++i)
  {
    float& error = mesh.cellInterfaceError[static_cast<Index>(i)];
    error = std::max(error, roundedUp(recordOf(cells_[i]).error()));
    largest = std::max(largest, error);
  }
  mesh.achieved.interfaceError = static_cast<double>(largest);
  mesh.achieved.regionError = static_cast<double>(roundedUp(regionError_));
}
}
