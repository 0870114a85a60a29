#include "Conversion/OutputGridErrors.h"

#include "Conversion/ValueConversion.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkPartitionedDataSetCollection.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

namespace strata::conversion
{
namespace
{
/// The errors of one material at the cells of all blocks, one after the other.
std::vector<double> errorsOfBlocks(const ReadSimulationResult& read, const std::vector<double>& errors)
{
  const InputGrid& input = read.source;
  const InputBlock& last = input.blocks.back();
  std::vector<double> result(
    static_cast<std::size_t>(last.cellOffset + last.cellCount), std::numeric_limits<double>::quiet_NaN());
  const std::vector<std::uint8_t>& hidden =
    std::visit([](const auto& grid) -> const std::vector<std::uint8_t>& { return grid.hidden; }, read.simulation.grid);
  for (std::size_t cell = 0; cell < errors.size(); ++cell)
  {
    if (hidden.empty() || !hidden[cell])
    {
      // A curved cell has the errors of all pieces that it is cut into.
      double& error = result[input.cellSource.empty() ? cell : static_cast<std::size_t>(input.cellSource[cell])];
      error = std::isnan(error) ? errors[cell] : error + errors[cell];
    }
  }
  return result;
}

Buffer<double> partOf(const InputBlock& block, const std::vector<double>& values)
{
  Buffer<double> result(block.cellCount);
  std::copy_n(values.begin() + block.cellOffset, block.cellCount, result.begin());
  return result;
}
}

void writeGridErrors(const ReadSimulationResult& read, const std::vector<std::vector<double>>& cellVolumeErrors,
  vtkPartitionedDataSetCollection* output)
{
  const unsigned int number = output->GetNumberOfPartitionedDataSets();
  const std::vector<InputBlock>& blocks = read.source.blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    auto copy = vtkSmartPointer<vtkDataObject>::Take(blocks[b].data->NewInstance());
    copy->ShallowCopy(blocks[b].data);
    output->SetPartition(number, static_cast<unsigned int>(b), copy);
  }
  for (std::size_t m = 0; m < cellVolumeErrors.size(); ++m)
  {
    const std::vector<double> errors = errorsOfBlocks(read, cellVolumeErrors[m]);
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      vtkDataObject* copy = output->GetPartitionAsDataObject(number, static_cast<unsigned int>(b));
      copy->GetAttributesAsFieldData(vtkDataObject::CELL)
        ->AddArray(
          give<vtkDoubleArray>("volume_error_" + read.simulation.materials[m].name, partOf(blocks[b], errors)));
    }
  }
  output->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), names::grid);
}
}
