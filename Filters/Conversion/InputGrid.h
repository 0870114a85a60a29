#pragma once

#include "Conversion/CurvedCells.h"

#include "Model/Errors.h"
#include "Model/Grid.h"

#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;
class vtkDataSetAttributes;

namespace strata::conversion
{
/// A data set that contributes to the simulation's grid, with the place of its cells and points in the
/// concatenation of all data sets' cells and points.
struct InputBlock
{
  std::string name;  ///< for messages: "" or " of block 'x'"
  std::string label; ///< the name of the block, or of the one that it is a part of; "" if neither has one
  vtkSmartPointer<vtkDataObject> data;
  vtkSmartPointer<vtkDataSetAttributes> cellData;
  vtkSmartPointer<vtkDataSetAttributes> pointData;
  Index cellOffset = 0;
  Index cellCount = 0;
  Index pointOffset = 0;
  Index pointCount = 0;
};

/// A point of the grid that is none of the blocks': weights of points in the concatenation of the blocks' points.
using BlendedPoint = std::vector<std::pair<Index, double>>;

/// A curved cell that linear pieces stand for; its nodes as points in the concatenation of the blocks' points.
struct CurvedCell
{
  std::shared_ptr<const CurvedPattern> pattern;
  std::vector<Index> nodes;
};

/// The simulation's grid and where its cells and points come from.
struct InputGrid
{
  Grid grid;
  std::vector<InputBlock> blocks;
  /// One per cell (point) of `grid`: position in the concatenation of all blocks' cells (points); blended points
  /// come last. Empty where the grid has exactly the cells (points) of one block, in their order.
  std::vector<Index> cellSource;
  std::vector<Index> pointSource;
  /// Points beyond the concatenation of the blocks' points: number `points of all blocks + i` in `pointSource` is
  /// `blends[i]`.
  std::vector<BlendedPoint> blends;
  /// The curved cells; where there are any, the point that each of the grid's corners had before points that
  /// coincide became one: fields may differ between cells that meet there.
  std::vector<CurvedCell> curved;
  std::vector<Index> cornerSource;
  /// The largest distance between a curved cell and its pieces, where it is bounded.
  double placeDeviation = 0.0;
  /// Whether there are curved cells whose distance from their pieces is not bounded.
  bool hasUnboundedCurves = false;
  /// Space in the box that no cell fills, or may not fill.
  bool hasOutside = false;
  Warnings warnings;
};

/// A cell of the grid in the concatenation of the blocks' cells, and its block.
Index sourceOfCell(const InputGrid& input, Index cell);
const InputBlock& blockOfCell(const InputGrid& input, Index cell);
/// "cell 12 of block 'left'": a cell of the grid by the number that the user knows.
std::string describeCell(const InputGrid& input, Index cell);

/// Reads the grid of a data set, a collection of data sets (appended; ghost cells and cells that finer ones
/// cover are dropped) or a hyper tree grid. Throws InvalidInput for a grid that can't be used.
InputGrid readGrid(vtkDataObject* data);
}
