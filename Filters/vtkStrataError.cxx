#include "vtkStrataError.h"

#include "OriginalInterfaces.h"
#include "SimulationFilterLists.h"

#include "Conversion/CellVolumes.h"
#include "Conversion/Guarded.h"
#include "Conversion/InputRepresentation.h"
#include "Conversion/OutputErrors.h"

#include "Native/ReadNativeData.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataError);

vtkStrataError::vtkStrataError()
{
  this->SetNumberOfInputPorts(3);
}

int vtkStrataError::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port == 2)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkStrataError::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

int vtkStrataError::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* output = vtkTable::GetData(outputs);
  return conversion::guarded(this, output, [&](strata::Progress& progress) {
    this->CheckMinimumVolumeFraction();
    vtkDataObject* represented = vtkDataObject::GetData(inputs[0]);
    const auto representation = conversion::readRepresentation(represented);
    conversion::SimulationOptions options = this->ArrayLists->options(*this);
    for (const strata::Field& field : representation.view.fields)
    {
      options.fieldArrays.push_back(field.name);
    }
    const auto input = conversion::splitCase(vtkDataObject::GetData(inputs[1]));
    const auto read = conversion::readSimulation(input, options);
    strata::Warnings warnings = read.warnings;
    const strata::Interfaces interfaces = originalInterfaces(
      input, vtkDataObject::GetData(inputs[2]), read.simulation, this->MinimumVolumeFraction, warnings, progress);
    conversion::warn(this, warnings);
    const auto native = strata::readNativeData(read.simulation, { this->MinimumVolumeFraction }, progress);
    const strata::RepresentationErrors errors = strata::measureRepresentation(representation.view, *native, interfaces,
      conversion::originalVolumes(read.simulation), progress, this->HausdorffTolerance);
    conversion::writeErrors(errors, representation.view, represented->GetFieldData(), output);
  });
}

void vtkStrataError::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HausdorffTolerance: " << this->HausdorffTolerance << "\n";
}
