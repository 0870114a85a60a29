#include "Conversion/InputArrays.h"

#include "Conversion/ValueConversion.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>

#include <algorithm>
#include <limits>

namespace strata::conversion
{
namespace
{
vtkDataSetAttributes* attributes(const InputBlock& block, Association association)
{
  return association == Association::Cells ? block.cellData : block.pointData;
}

std::string describeMissing(const InputBlock& block, Association association, const std::string& name)
{
  return "The " + std::string(association == Association::Cells ? "cell" : "point") + " array '" + name + "'" +
         block.name + " is missing";
}

/// A block's array. Throws InvalidInput if it is missing or too short.
vtkDataArray* arrayOf(const InputBlock& block, Association association, const std::string& name)
{
  const bool cells = association == Association::Cells;
  vtkDataArray* array = attributes(block, association)->GetArray(name.c_str());
  if (!array)
  {
    throw InvalidInput(describeMissing(block, association, name));
  }
  const Index expected = cells ? block.cellCount : block.pointCount;
  if (array->GetNumberOfTuples() != expected)
  {
    throw InvalidInput("The array '" + name + "'" + block.name + " has " + std::to_string(array->GetNumberOfTuples()) +
                       " values for " + std::to_string(expected) + (cells ? " cells" : " points"));
  }
  return array;
}

bool isFloating(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

const std::vector<Index>& sources(const InputGrid& input, Association association)
{
  return association == Association::Cells ? input.cellSource : input.pointSource;
}

/// Cells or points of all blocks together.
Index totalOf(const InputGrid& input, Association association)
{
  const InputBlock& last = input.blocks.back();
  return association == Association::Cells ? last.cellOffset + last.cellCount : last.pointOffset + last.pointCount;
}

/// Calls `copy(block number, position in block, position in result)` for each cell or point of the grid.
template<typename Function>
void forEachSource(const InputGrid& input, Association association, const Function& copy)
{
  const auto offset = [&](const InputBlock& block) {
    return association == Association::Cells ? block.cellOffset : block.pointOffset;
  };
  const std::vector<Index>& source = sources(input, association);
  const Index end = totalOf(input, association);
  auto block = input.blocks.begin();
  Index blockEnd = 0;
  for (std::size_t i = 0; i < source.size() && source[i] < end; ++i)
  {
    if (source[i] < offset(*block) || source[i] >= blockEnd)
    {
      const auto next = std::upper_bound(input.blocks.begin(), input.blocks.end(), source[i],
        [&](Index position, const InputBlock& other) { return position < offset(other); });
      block = std::prev(next);
      blockEnd = next == input.blocks.end() ? end : offset(*next);
    }
    copy(static_cast<std::size_t>(block - input.blocks.begin()), source[i] - offset(*block), i);
  }
}

/// The values of all blocks' arrays; NaN in blocks that have none.
template<typename T>
ValueArray gathered(const InputGrid& input, Association association, const BlockArrays& arrays)
{
  const int components = arrays.components;
  const std::vector<ValueArray>& parts = arrays.parts;
  std::vector<T> result(sources(input, association).size() * static_cast<std::size_t>(components));
  forEachSource(input, association, [&](std::size_t block, Index from, std::size_t to) {
    for (int c = 0; c < components; ++c)
    {
      result[to * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)] =
        parts[block] ? static_cast<T>(parts[block](from, c)) : std::numeric_limits<T>::quiet_NaN();
    }
  });
  const Index end = totalOf(input, association);
  for (std::size_t i = sources(input, association).size(); association == Association::Points && i-- > 0;)
  {
    const Index source = input.pointSource[i];
    if (source < end)
    {
      break; // blended points come last
    }
    for (int c = 0; c < components; ++c)
    {
      result[i * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)] =
        static_cast<T>(valueAt(input, arrays, source, c));
    }
  }
  return ownedValues(std::move(result), components);
}
}

std::vector<ArrayInfo> arraysOf(const InputGrid& input, Association association)
{
  std::vector<ArrayInfo> result;
  for (const InputBlock& block : input.blocks)
  {
    vtkDataSetAttributes* data = attributes(block, association);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && array->GetName() && !find(result, array->GetName()))
      {
        result.push_back({ array->GetName(), array->GetNumberOfComponents(), isFloating(array),
          array->GetDataType() == VTK_UNSIGNED_CHAR });
      }
    }
  }
  return result;
}

const ArrayInfo* find(const std::vector<ArrayInfo>& arrays, const std::string& name)
{
  const auto at =
    std::find_if(arrays.begin(), arrays.end(), [&](const ArrayInfo& array) { return array.name == name; });
  return at == arrays.end() ? nullptr : &*at;
}

double valueAt(const InputGrid& input, const BlockArrays& arrays, Index point, int component)
{
  const Index end = totalOf(input, Association::Points);
  if (point >= end)
  {
    double sum = 0.0;
    for (const auto& [node, weight] : input.blends[static_cast<std::size_t>(point - end)])
    {
      sum += weight * valueAt(input, arrays, node, component);
    }
    return sum;
  }
  const auto after = std::upper_bound(input.blocks.begin(), input.blocks.end(), point,
    [](Index position, const InputBlock& block) { return position < block.pointOffset; });
  const auto block = static_cast<std::size_t>(std::prev(after) - input.blocks.begin());
  return arrays.parts[block] ? arrays.parts[block](point - input.blocks[block].pointOffset, component)
                             : std::numeric_limits<double>::quiet_NaN();
}

BlockArrays blockArrays(const InputGrid& input, Association association, const std::string& name, Warnings* gaps)
{
  const std::vector<ArrayInfo> infos = arraysOf(input, association);
  const ArrayInfo* info = find(infos, name);
  BlockArrays result;
  result.components = info ? info->components : 1;
  for (const InputBlock& block : input.blocks)
  {
    if (gaps && info && !attributes(block, association)->HasArray(name.c_str()))
    {
      gaps->push_back(describeMissing(block, association, name) + ": the field is unknown there");
      result.parts.emplace_back();
      continue;
    }
    vtkDataArray* array = arrayOf(block, association, name);
    result.floats = result.floats && array->GetDataType() == VTK_FLOAT;
    result.parts.push_back(valuesOf(array));
    if (result.parts.back().components() != info->components)
    {
      throw InvalidInput("The array '" + name + "'" + block.name + " has another number of components than elsewhere");
    }
  }
  return result;
}

ValueArray values(const InputGrid& input, Association association, const std::string& name, Warnings* gaps)
{
  const BlockArrays arrays = blockArrays(input, association, name, gaps);
  if (sources(input, association).empty())
  {
    return arrays.parts.front();
  }
  return arrays.floats ? gathered<float>(input, association, arrays) : gathered<double>(input, association, arrays);
}

std::vector<std::int64_t> integers(const InputGrid& input, const std::string& cellArray)
{
  std::vector<std::vector<std::int64_t>> parts;
  for (const InputBlock& block : input.blocks)
  {
    vtkDataArray* array = arrayOf(block, Association::Cells, cellArray);
    if (isFloating(array) || array->GetNumberOfComponents() != 1)
    {
      throw InvalidInput("The array '" + cellArray + "'" + block.name + " holds " +
                         std::to_string(array->GetNumberOfComponents()) + " " + array->GetDataTypeAsString() +
                         " per cell; it must have one integer per cell");
    }
    parts.push_back(integersOf(array));
  }
  if (input.cellSource.empty())
  {
    return parts.front();
  }
  std::vector<std::int64_t> result(input.cellSource.size());
  forEachSource(input, Association::Cells,
    [&](std::size_t block, Index from, std::size_t to) { result[to] = parts[block][static_cast<std::size_t>(from)]; });
  return result;
}

std::string integerAt(const InputGrid& input, const std::string& cellArray, Index cell)
{
  const InputBlock& block = blockOfCell(input, cell);
  return arrayOf(block, Association::Cells, cellArray)
    ->GetVariantValue(sourceOfCell(input, cell) - block.cellOffset)
    .ToString();
}

std::vector<std::size_t> blocksOfCells(const InputGrid& input)
{
  std::vector<std::size_t> result(static_cast<std::size_t>(cellCount(input.grid)), 0);
  forEachSource(input, Association::Cells, [&](std::size_t block, Index, std::size_t to) { result[to] = block; });
  return result;
}

std::string activeScalars(const InputGrid& input)
{
  for (const Association association : { Association::Cells, Association::Points })
  {
    for (const InputBlock& block : input.blocks)
    {
      vtkDataArray* scalars = attributes(block, association)->GetScalars();
      if (scalars && scalars->GetName())
      {
        return scalars->GetName();
      }
    }
  }
  return "";
}
}
