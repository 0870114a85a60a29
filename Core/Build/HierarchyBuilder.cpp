#include "Build/HierarchyBuilder.h"

#include "Build/BaseMesh.h"
#include "Build/CellFunctions.h"
#include "Build/CellRowsOf.h"
#include "Build/CertifiedFields.h"
#include "Build/CertifiedInterfaces.h"
#include "Build/DepthFirst.h"
#include "Build/MaterialsHeld.h"
#include "Model/Errors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>

namespace strata
{
namespace
{
void check(const NativeData& native, const BuildOptions& options)
{
  if (native.materials().size() > static_cast<std::size_t>(MaterialSet::capacity))
  {
    throw InvalidInput("the data has " + std::to_string(native.materials().size()) + " materials; at most " +
                       std::to_string(MaterialSet::capacity) + " are supported");
  }
  const Vector size = native.box().size();
  if (native.box().empty() || !size.allFinite() || size.minCoeff() <= 0.0)
  {
    throw InvalidInput("the data has no volume: its box is empty or flat");
  }
  for (const int cubes : options.baseCubes)
  {
    if (cubes < 1 || cubes > Lattice::maximumCubes)
    {
      throw InvalidInput("BaseCubes is " + std::to_string(cubes) + "; it must lie in [1, " +
                         std::to_string(Lattice::maximumCubes) + "]");
    }
  }
}

Lattice latticeFor(const NativeData& native, const BuildOptions& options)
{
  check(native, options);
  return { native.box(), options.baseCubes };
}

MaterialSet allMaterials(std::size_t count)
{
  MaterialSet result;
  for (std::size_t m = 0; m < count; ++m)
  {
    result.insert(MaterialId(static_cast<Index>(m)));
  }
  return result;
}

template<typename Body>
void parallelFor(std::size_t begin, std::size_t end, Progress& progress, const Body& body)
{
  tbb::parallel_for(begin, end, [&](std::size_t i) {
    progress.check();
    body(i);
  });
}
}

HierarchyBuilder::HierarchyBuilder(std::shared_ptr<const NativeData> native, const Interfaces& interfaces,
  const BuildOptions& options, Progress& progress) :
  HierarchyBuilder(
    native, std::make_shared<InterfaceGeometry>(interfaces, *native, options.distanceMethod), options, progress)
{}

HierarchyBuilder::HierarchyBuilder(std::shared_ptr<const NativeData> native,
  std::shared_ptr<const InterfaceGeometry> interfaces, const BuildOptions& options, Progress& progress) :
  native_(std::move(native)),
  interfaces_(std::move(interfaces)), nativeElements_(options.nativeElements),
  vertexValues_(*native_, interfaces_, options.ghostMethod)
{
  hierarchy_.lattice = latticeFor(*native_, options);
  hierarchy_.materials = native_->materials();
  hierarchy_.fields = native_->fields();
  hierarchy_.valuesPerMaterial = 1 + native_->componentCount();
  makeBaseMesh();
  fillBaseMesh(progress);
}

void HierarchyBuilder::makeBaseMesh()
{
  std::map<std::array<std::int32_t, 3>, VertexId> vertexAt;
  const MaterialSet all = allMaterials(hierarchy_.materials.size());
  for (const BaseCell& base : baseCells(hierarchy_.lattice))
  {
    HierarchyCell cell;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      VertexId& vertex = vertexAt[base.corners[corner].at];
      vertex = vertex.valid() ? vertex : addVertex(base.corners[corner], all);
      cell.corners[corner] = vertex;
    }
    cell.inverted = base.inverted;
    joinDiamond(addCell(cell));
  }
  hierarchy_.rootCount = static_cast<Index>(hierarchy_.cells.size());
}

void HierarchyBuilder::fillBaseMesh(Progress& progress)
{
  growCellArrays();
  evaluateVertices(0, progress);
  const CellElements all =
    allElements(*native_, interfaces_->elements, nativeElements_ == NativeElements::Cells, progress);
  const MaterialSet materials = allMaterials(hierarchy_.materials.size());
  parallelFor(0, hierarchy_.cells.size(), progress,
    [&](std::size_t c) { finishCell(CellId(static_cast<Index>(c)), all, materials); });
}

CellId HierarchyBuilder::addCell(const HierarchyCell& cell)
{
  hierarchy_.cells.push_back(cell);
  return CellId(static_cast<Index>(hierarchy_.cells.size()) - 1);
}

VertexId HierarchyBuilder::addVertex(const LatticePoint& point, MaterialSet materials)
{
  hierarchy_.vertices.push_back(point);
  hierarchy_.vertexMaterials.push_back(materials);
  hierarchy_.valueOffsets.push_back(static_cast<Index>(hierarchy_.values.size()));
  const auto count = static_cast<std::size_t>(materials.size() * hierarchy_.valuesPerMaterial);
  hierarchy_.values.resize(hierarchy_.values.size() + count);
  return VertexId(static_cast<Index>(hierarchy_.vertices.size()) - 1);
}

void HierarchyBuilder::joinDiamond(CellId id)
{
  HierarchyCell& cell = hierarchy_.cells[static_cast<std::size_t>(id.value)];
  const auto& points = hierarchy_.vertices;
  const LatticePoint center = midpoint(points[static_cast<std::size_t>(cell.corners[0].value)],
    points[static_cast<std::size_t>(cell.corners[cell.tag].value)]);
  DiamondId diamond = hierarchy_.diamondAt(center);
  if (!diamond.valid())
  {
    diamond = DiamondId(static_cast<Index>(hierarchy_.diamonds.size()));
    hierarchy_.diamonds.push_back({ center, CellId(), VertexId(), {} });
    hierarchy_.table.insert(diamond, hierarchy_.diamonds);
  }
  cell.diamond = diamond;
  CellId& first = hierarchy_.diamonds[static_cast<std::size_t>(diamond.value)].firstCell;
  cell.nextInDiamond = first;
  first = id;
}

MaterialSet HierarchyBuilder::materialsAround(DiamondId diamond) const
{
  MaterialSet result;
  hierarchy_.forCellsOf(diamond, [&](CellId c) { result = result | hierarchy_.materialsOf(c); });
  return result;
}

void HierarchyBuilder::addChildren(CellId parent, VertexId middle)
{
  const HierarchyCell cell = hierarchy_.cell(parent);
  const std::size_t t = cell.tag;
  HierarchyCell first;
  first.corners = cell.corners;
  first.corners[t] = middle;
  first.tag = static_cast<std::uint8_t>(t == 1 ? 3 : t - 1);
  first.level = static_cast<std::uint8_t>(cell.level + 1);
  first.inverted = cell.inverted;
  HierarchyCell second = first;
  std::copy(
    cell.corners.begin() + 1, cell.corners.begin() + 1 + static_cast<std::ptrdiff_t>(t), second.corners.begin());
  // The middle takes corner 0's place and then moves on by t places, each an exchange.
  second.inverted = cell.inverted != (t % 2 == 1);
  const CellId child = addCell(first);
  addCell(second);
  hierarchy_.cells[static_cast<std::size_t>(parent.value)].firstChild = child;
}

void HierarchyBuilder::growCellArrays()
{
  const std::size_t count = hierarchy_.cells.size();
  elements_.resize(count);
  hierarchy_.cellMaterials.resize(count);
  hierarchy_.interfaceErrors.resize(count);
  hierarchy_.fieldErrors.resize(count * hierarchy_.fields.size());
}

void HierarchyBuilder::evaluateVertices(std::size_t first, Progress& progress)
{
  parallelFor(first, hierarchy_.vertices.size(), progress, [&](std::size_t v) {
    vertexValues_.evaluate(hierarchy_.lattice.position(hierarchy_.vertices[v]), hierarchy_.vertexMaterials[v],
      hierarchy_.values.data() + hierarchy_.valueOffsets[v]);
  });
}

void HierarchyBuilder::finishCell(CellId id, const CellElements& candidates, MaterialSet allowed)
{
  const auto c = static_cast<std::size_t>(id.value);
  const Barycentric barycentric(cornerPositions(hierarchy_, id));
  elements_[c] = elementsWithin(barycentric, candidates, *native_, interfaces_->elements);
  hierarchy_.cellMaterials[c] = materialsHeld(hierarchy_, id, elements_[c], allowed, *native_, interfaces_->elements);
  const CellErrors errors = errorsOf(hierarchy_, id, barycentric, elements_[c]);
  hierarchy_.interfaceErrors[c] = errors.interfaceError;
  std::copy(errors.fieldErrors.begin(), errors.fieldErrors.end(),
    hierarchy_.fieldErrors.begin() + static_cast<std::ptrdiff_t>(c * hierarchy_.fields.size()));
}

CellElements HierarchyBuilder::gatherElements(CellId top) const
{
  std::vector<const CellElements*> parts;
  std::vector<CellId> stack = { top };
  while (!stack.empty())
  {
    const CellId c = stack.back();
    stack.pop_back();
    const CellId child = hierarchy_.cell(c).firstChild;
    if (!child.valid())
    {
      parts.push_back(&elements_[static_cast<std::size_t>(c.value)]);
      continue;
    }
    stack.push_back(child);
    stack.push_back(CellId(child.value + 1));
  }
  return united(parts);
}

std::vector<float> HierarchyBuilder::valuesAt(VertexId vertex, MaterialId m) const
{
  const MaterialSet all = hierarchy_.vertexMaterials[static_cast<std::size_t>(vertex.value)] | MaterialSet::of(m);
  const auto stride = static_cast<std::size_t>(hierarchy_.valuesPerMaterial);
  std::vector<float> values(static_cast<std::size_t>(all.size()) * stride);
  vertexValues_.evaluate(hierarchy_.position(vertex), all, values.data());
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(all.rank(m)) * stride);
  return { first, first + static_cast<std::ptrdiff_t>(stride) };
}

CellRows HierarchyBuilder::rows(CellId cell) const
{
  const Barycentric barycentric(cornerPositions(hierarchy_, cell));
  const CellElements elements = gatherElements(cell);
  CellRows rows = cellRows(hierarchy_, cell, barycentric, elements, *native_, interfaces_->elements);
  if (nativeElements_ == NativeElements::Cells)
  {
    addClippedCorners(barycentric, elements, interfaces_->elements, rows);
    addNativeCellPoints(hierarchy_, cell, barycentric, elements, *native_, rows);
  }
  return rows;
}

std::vector<InterfacePiece> HierarchyBuilder::interfacePieces(CellId cell) const
{
  const Barycentric barycentric(cornerPositions(hierarchy_, cell));
  const CellElements elements = gatherElements(cell);
  std::vector<InterfacePiece> pieces;
  for (std::uint32_t i = 0; i < elements.triangleCount(); ++i)
  {
    const std::uint32_t triangle = elements.triangles()[i];
    const auto& [a, b, c] = interfaces_->elements.triangles[triangle];
    const std::vector<Vector>& points = interfaces_->elements.points;
    const ClippedTriangle clipped(
      barycentric, { points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)],
                     points[static_cast<std::size_t>(c)] });
    if (!clipped.empty())
    {
      const auto pair = static_cast<std::size_t>(interfaces_->elements.pairOfTriangle[triangle]);
      const InterfaceElements::Pair& materials = interfaces_->elements.pairs[pair];
      pieces.push_back(
        { UnorderedPair::of(materials.positive, materials.negative), { clipped.begin(), clipped.end() } });
    }
  }
  return pieces;
}

CellErrors HierarchyBuilder::errors(const Hierarchy& values, CellId cell) const
{
  return errorsOf(values, cell, Barycentric(cornerPositions(hierarchy_, cell)), gatherElements(cell));
}

CellErrors HierarchyBuilder::errorsOf(
  const Hierarchy& values, CellId cell, const Barycentric& barycentric, const CellElements& elements) const
{
  CellErrors errors = cellErrors(values, cell, barycentric, elements, *native_, interfaces_->elements);
  if (nativeElements_ == NativeElements::Cells)
  {
    addNativeCellErrors(values, cell, barycentric, elements, *native_, errors);
    errors.interfaceError =
      roundedUp(certifiedInterfaceError(values, cell, barycentric, elements, interfaces_->elements));
  }
  return errors;
}

void HierarchyBuilder::split(const std::vector<DiamondId>& diamonds, Progress& progress)
{
  const std::size_t firstVertex = hierarchy_.vertices.size();
  const std::size_t firstCell = hierarchy_.cells.size();
  std::vector<CellId> parents;
  for (const DiamondId id : diamonds)
  {
    Diamond& diamond = hierarchy_.diamonds[static_cast<std::size_t>(id.value)];
    diamond.vertex = addVertex(diamond.center, materialsAround(id));
    std::size_t parent = 0;
    for (const LatticePoint& center : hierarchy_.lattice.parents(diamond.center))
    {
      diamond.parents[parent++] = hierarchy_.diamondAt(center);
    }
    hierarchy_.forCellsOf(id, [&](CellId c) { parents.push_back(c); });
  }
  evaluateVertices(firstVertex, progress);
  for (const CellId parent : parents)
  {
    addChildren(parent, hierarchy_.diamond(hierarchy_.cell(parent).diamond).vertex);
  }
  growCellArrays();
  parallelFor(0, parents.size(), progress, [&](std::size_t i) {
    CellElements& own = elements_[static_cast<std::size_t>(parents[i].value)];
    const MaterialSet materials = hierarchy_.materialsOf(parents[i]);
    const CellId child = hierarchy_.cell(parents[i]).firstChild;
    finishCell(child, own, materials);
    finishCell(CellId(child.value + 1), own, materials);
    own = CellElements();
  });
  for (std::size_t c = firstCell; c < hierarchy_.cells.size(); ++c)
  {
    joinDiamond(CellId(static_cast<Index>(c)));
  }
}

void HierarchyBuilder::arrange(Level& level, Progress& progress)
{
  assert(level.extra.empty());
  // A tenth out of order costs less than arranging all.
  if (10 * (hierarchy_.cells.size() - arrangedCells_) <= hierarchy_.cells.size())
  {
    return;
  }
  const HierarchyOrder order = depthFirst(hierarchy_, progress);
  progress.check();
  reorder(elements_, order.cells);
  reorder(hierarchy_, order, progress);
  // The hierarchy may have grown since the level was selected.
  level.active.resize(hierarchy_.diamonds.size(), 0);
  reorder(level.active, order.diamonds);
  arrangedCells_ = hierarchy_.cells.size();
}
}
