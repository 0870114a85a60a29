#pragma once

#include "Conversion/InputGrid.h"

#include "Model/Simulation.h"

#include <string>
#include <vector>

namespace strata::conversion
{
/// Which of an input's arrays are meant.
struct ArrayInfo
{
  std::string name;
  int components = 1;
  bool floating = false; ///< values of type float or double
  bool bytes = false;    ///< values of type unsigned char
};

/// The numeric arrays of an input, blocks' arrays taken together by name, in order of appearance.
std::vector<ArrayInfo> arraysOf(const InputGrid& input, Association association);

/// The entry of that name, or null.
const ArrayInfo* find(const std::vector<ArrayInfo>& arrays, const std::string& name);

/// The arrays of one name of all blocks; null where a block has none.
struct BlockArrays
{
  std::vector<ValueArray> parts;
  int components = 1;
  bool floats = true;
};

/// The blocks' arrays of that name; throws and warns as `values` does.
BlockArrays blockArrays(
  const InputGrid& input, Association association, const std::string& name, Warnings* gaps = nullptr);

/// A component at a point of the blocks, or at one that others make up (InputGrid::blends), by its place in the
/// concatenation of all blocks' points.
double valueAt(const InputGrid& input, const BlockArrays& arrays, Index point, int component);

/// An array's values, one tuple per cell or point of the grid. Throws InvalidInput where a block has it with
/// another number of tuples or components, or lacks it; with `gaps`, its values in a block that lacks it are NaN
/// and there is a warning that names the block.
ValueArray values(const InputGrid& input, Association association, const std::string& name, Warnings* gaps = nullptr);

/// The same for integers, one per cell. Throws InvalidInput for arrays of another kind.
std::vector<std::int64_t> integers(const InputGrid& input, const std::string& cellArray);

/// The value that a cell has in such an array, as a text: that of an unsigned one may be too large for `integers`.
std::string integerAt(const InputGrid& input, const std::string& cellArray, Index cell);

/// The number of the block that each cell of the grid is in.
std::vector<std::size_t> blocksOfCells(const InputGrid& input);

/// The name of the active scalars of the first block that has any, in cells or else in points; "" if none has.
std::string activeScalars(const InputGrid& input);
}
