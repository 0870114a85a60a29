#include "Conversion/InputGrid.h"

#include "Conversion/BlockNames.h"
#include "Conversion/HyperTreeGrids.h"
#include "Conversion/StructuredGrids.h"
#include "Conversion/UnstructuredGrids.h"

#include <vtkAMRUtilities.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkHyperTreeGrid.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkOverlappingAMR.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUniformGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <sstream>

namespace strata::conversion
{
namespace
{
struct NamedData
{
  vtkSmartPointer<vtkDataObject> data;
  std::string name;
  std::string label;
};

/// AMR grids whose file doesn't mark the cells that finer ones cover: a shallow copy with the marks.
vtkSmartPointer<vtkCompositeDataSet> withCoveredCells(vtkCompositeDataSet* data)
{
  auto* amr = vtkOverlappingAMR::SafeDownCast(data);
  if (!amr)
  {
    return data;
  }
  auto copy = vtkSmartPointer<vtkOverlappingAMR>::New();
  // Not ShallowCopy: setting a data set after it adds a second one.
  copy->CopyStructure(amr);
  bool marked = true;
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int i = 0; i < amr->GetNumberOfDataSets(level); ++i)
    {
      if (vtkUniformGrid* grid = amr->GetDataSet(level, i))
      {
        marked = marked && grid->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName());
        vtkNew<vtkUniformGrid> gridCopy;
        gridCopy->ShallowCopy(grid);
        copy->SetDataSet(level, i, gridCopy);
      }
    }
  }
  if (marked)
  {
    return data;
  }
  vtkAMRUtilities::BlankCells(copy);
  return copy;
}

std::vector<NamedData> leavesOf(vtkDataObject* data)
{
  std::vector<NamedData> leaves;
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    leaves.push_back({ data, "", "" });
    return leaves;
  }
  const vtkSmartPointer<vtkCompositeDataSet> covered = withCoveredCells(composite);
  const auto names = blockNames(data);
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(covered->NewIterator());
  iterator->SkipEmptyNodesOn();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const char* name =
      iterator->HasCurrentMetaData() ? iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
    const std::string label = name ? name : std::to_string(iterator->GetCurrentFlatIndex());
    const auto known = names.find(iterator->GetCurrentDataObject());
    leaves.push_back({ iterator->GetCurrentDataObject(), " of block '" + label + "'",
      known == names.end() ? std::string() : known->second });
  }
  if (leaves.size() == 1)
  {
    leaves.front().name.clear();
  }
  return leaves;
}

bool isRectilinear(vtkDataObject* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  return image ? isAxisAligned(image) : vtkRectilinearGrid::SafeDownCast(data) != nullptr;
}

void addBlock(UnstructuredBuilder& builder, const NamedData& block)
{
  vtkDataObject* data = block.data;
  if (vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
      vtkStructuredGrid::SafeDownCast(data))
  {
    addStructured(builder, vtkDataSet::SafeDownCast(data), block.name);
  }
  else if (auto* explicitGrid = vtkExplicitStructuredGrid::SafeDownCast(data))
  {
    addExplicit(builder, explicitGrid, block.name);
  }
  else if (auto* unstructured = vtkUnstructuredGrid::SafeDownCast(data))
  {
    addUnstructured(builder, unstructured, block.name);
  }
  else if (auto* trees = vtkHyperTreeGrid::SafeDownCast(data))
  {
    addHyperTrees(builder, trees, block.name);
  }
  else if (vtkPolyData::SafeDownCast(data))
  {
    builder.ignore();
  }
  else
  {
    throw InvalidInput(std::string("A ") + data->GetClassName() + block.name + " is no simulation grid");
  }
}
}

Index sourceOfCell(const InputGrid& input, Index cell)
{
  return input.cellSource.empty() ? cell : input.cellSource[static_cast<std::size_t>(cell)];
}

const InputBlock& blockOfCell(const InputGrid& input, Index cell)
{
  const auto after = std::upper_bound(input.blocks.begin(), input.blocks.end(), sourceOfCell(input, cell),
    [](Index position, const InputBlock& block) { return position < block.cellOffset; });
  return *std::prev(after);
}

std::string describeCell(const InputGrid& input, Index cell)
{
  const InputBlock& block = blockOfCell(input, cell);
  return "cell " + std::to_string(sourceOfCell(input, cell) - block.cellOffset) + block.name;
}

InputGrid readGrid(vtkDataObject* data)
{
  const std::vector<NamedData> leaves = leavesOf(data);
  if (leaves.size() == 1 && isRectilinear(leaves.front().data))
  {
    InputGrid result = readRectilinear(vtkDataSet::SafeDownCast(leaves.front().data));
    result.blocks.front().label = leaves.front().label;
    return result;
  }
  if (leaves.size() == 1 && vtkPolyData::SafeDownCast(leaves.front().data))
  {
    throw InvalidInput("The input is a surface (vtkPolyData): a grid of cells with a volume is needed");
  }
  UnstructuredBuilder builder;
  for (const NamedData& leaf : leaves)
  {
    // Readers leave empty data sets, without arrays, for the parts that hold nothing.
    if (leaf.data->GetNumberOfElements(vtkDataObject::CELL) > 0)
    {
      builder.nameBlocks(leaf.label);
      addBlock(builder, leaf);
    }
  }
  return builder.finish();
}
}
