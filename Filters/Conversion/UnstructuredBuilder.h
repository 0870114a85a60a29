#pragma once

#include "Conversion/CellTable.h"
#include "Conversion/CurvedCells.h"
#include "Conversion/InputGrid.h"

namespace strata::conversion
{
/// Collects the cells of one or several data sets into one unstructured grid.
class UnstructuredBuilder
{
public:
  /// Says what the blocks that begin from now on are called (InputBlock::label).
  void nameBlocks(const std::string& label) { label_ = label; }
  /// Begins a data set; the cells that follow count its points from 0.
  void beginBlock(InputBlock block, std::vector<Vector> points);

  /// Adds a cell of the current block. `source` is its number there, `points` the VTK cell's points.
  void add(const CellKind& kind, Index source, const Index* points, Index pointCount);
  /// Adds a polyhedron: its points, and its faces as VTK lists them (count, points, count, points, ...).
  void addPolyhedron(Index source, const Index* points, Index pointCount, const Index* faces, Index faceCount);
  /// Throws InvalidInput if the current block lacks a point of a cell.
  void checkPoints(Index source, const Index* points, Index pointCount) const;
  /// Adds the linear pieces of a curved cell of the current block.
  void addCurved(const std::shared_ptr<const CurvedPattern>& pattern, Index source, const Index* points);
  /// Counts a curved cell that is added as if it were straight.
  void straighten() { ++straightened_; }
  /// Counts a cell without volume, which is left out.
  void ignore() { ++ignored_; }
  /// Points that coincide become one, although the data set lists them apart.
  void weldAtTheEnd() { weld_ = true; }

  /// Checks the cells, merges points and drops those that no cell uses.
  InputGrid finish();

private:
  Index global(Index source, Index point) const;
  Index blended(const NodeWeights& weights, const std::vector<Index>& nodes);
  void finishCell(CellShape shape, Index source);
  void checkFinite(const InputGrid& result) const;
  void resolveBlends(InputGrid& result);
  void compactPoints(InputGrid& result);
  void warn(InputGrid& result) const;

  UnstructuredGrid grid_;
  std::vector<InputBlock> blocks_;
  std::string label_;
  std::vector<Index> cellSource_;
  Index ignored_ = 0;
  Index straightened_ = 0;
  std::vector<BlendedPoint> blends_;
  std::vector<CurvedCell> curved_;
  bool weld_ = false;
};
}
