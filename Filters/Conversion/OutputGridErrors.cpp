#include "Conversion/OutputGridErrors.h"

#include "Conversion/ValueConversion.h"

#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkPartitionedDataSetCollection.h>

#include <algorithm>
#include <limits>

namespace strata::conversion
{
namespace
{
std::vector<vtkDataObject*> leavesOf(vtkDataObject* grid)
{
  std::vector<vtkDataObject*> leaves;
  auto* composite = vtkCompositeDataSet::SafeDownCast(grid);
  if (!composite)
  {
    leaves.push_back(grid);
    return leaves;
  }
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    leaves.push_back(iterator->GetCurrentDataObject());
  }
  return leaves;
}

/// A block's part of the errors of one material, one value per cell of the block.
Buffer<double> errorsOf(const InputBlock& block, const InputGrid& input, const std::vector<double>& errors)
{
  Buffer<double> result(block.cellCount);
  if (input.cellSource.empty())
  {
    std::copy_n(
      errors.begin(), std::min<std::size_t>(errors.size(), static_cast<std::size_t>(block.cellCount)), result.begin());
    return result;
  }
  std::fill(result.begin(), result.end(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t cell = 0; cell < input.cellSource.size(); ++cell)
  {
    const Index place = input.cellSource[cell] - block.cellOffset;
    if (place >= 0 && place < block.cellCount)
    {
      result[place] = errors[cell];
    }
  }
  return result;
}
}

void writeGridErrors(vtkDataObject* grid, const ReadSimulationResult& read,
  const std::vector<std::vector<double>>& cellVolumeErrors, vtkPartitionedDataSetCollection* output)
{
  const unsigned int number = output->GetNumberOfPartitionedDataSets();
  const std::vector<vtkDataObject*> leaves = leavesOf(grid);
  for (std::size_t b = 0; b < leaves.size() && b < read.source.blocks.size(); ++b)
  {
    auto copy = vtkSmartPointer<vtkDataObject>::Take(leaves[b]->NewInstance());
    copy->ShallowCopy(leaves[b]);
    vtkFieldData* cellData = copy->GetAttributesAsFieldData(vtkDataObject::CELL);
    for (std::size_t m = 0; m < cellVolumeErrors.size() && cellData; ++m)
    {
      if (!cellVolumeErrors[m].empty())
      {
        cellData->AddArray(give<vtkDoubleArray>("volume_error_" + read.simulation.materials[m].name,
          errorsOf(read.source.blocks[b], read.source, cellVolumeErrors[m])));
      }
    }
    output->SetPartition(number, static_cast<unsigned int>(b), copy);
  }
  output->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), names::grid);
}
}
