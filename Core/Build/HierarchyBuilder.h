#pragma once

#include "Build/CellErrors.h"
#include "Build/VertexValues.h"
#include "Model/CellRows.h"
#include "Model/InterfacePiece.h"
#include "Model/Level.h"
#include "Model/Progress.h"

namespace strata
{
/// Grows a hierarchy from the base mesh down, diamond by diamond, from native data and interfaces (design 3.2).
///
/// Every cell that nothing has split yet keeps its native elements, so that growth can go on at any time without
/// a look at the whole input. The same diamonds give the same hierarchy but for the order of its arrays.
class HierarchyBuilder
{
public:
  /// Makes the base mesh. Throws InvalidInput for a box without volume and too many materials or base cubes.
  HierarchyBuilder(std::shared_ptr<const NativeData> native, const Interfaces& interfaces, const BuildOptions& options,
    Progress& progress);
  /// The same with what another build left of the same interfaces; `interfaces` are those of options.distanceMethod.
  HierarchyBuilder(std::shared_ptr<const NativeData> native, std::shared_ptr<const InterfaceGeometry> interfaces,
    const BuildOptions& options, Progress& progress);

  const Hierarchy& hierarchy() const { return hierarchy_; }

  /// Splits diamonds all of whose parents are split and that are not split themselves.
  void split(const std::vector<DiamondId>& diamonds, Progress& progress);

  /// Brings the hierarchy into the order in which levels run through it, if enough of it is new: all ids change.
  /// `level` must be one of it, without extra values; its diamonds are renumbered alike.
  void arrange(Level& level, Progress& progress);

  /// A cell's native elements as rows; for a cell that is split, gathered from its descendants.
  CellRows rows(CellId cell) const;
  /// A cell's own errors with other values at the vertices: `values` is this hierarchy but for those.
  CellErrors errors(const Hierarchy& values, CellId cell) const;

  /// The parts of the original interface triangles within a cell.
  std::vector<InterfacePiece> interfacePieces(CellId cell) const;

  /// The values of any material at a vertex, in the layout of Hierarchy::values.
  std::vector<float> valuesAt(VertexId vertex, MaterialId m) const;

private:
  CellElements gatherElements(CellId cell) const;
  CellErrors errorsOf(
    const Hierarchy& values, CellId cell, const Barycentric& barycentric, const CellElements& elements) const;
  void makeBaseMesh();
  void fillBaseMesh(Progress& progress);
  CellId addCell(const HierarchyCell& cell);
  VertexId addVertex(const LatticePoint& point, MaterialSet materials);
  MaterialSet materialsAround(DiamondId diamond) const;
  void joinDiamond(CellId cell);
  void addChildren(CellId parent, VertexId middle);
  void evaluateVertices(std::size_t first, Progress& progress);
  void finishCell(CellId cell, const CellElements& candidates, MaterialSet allowed);
  void growCellArrays();

  std::shared_ptr<const NativeData> native_;
  std::shared_ptr<const InterfaceGeometry> interfaces_;
  NativeElements nativeElements_;
  VertexValues vertexValues_;
  Hierarchy hierarchy_;
  std::size_t arrangedCells_ = 0;      ///< how many there were when they were last arranged
  std::vector<CellElements> elements_; ///< one per cell; empty once the cell is split
};
}
