#include "vtkStrataMaterialInterfaces.h"

#include "SimulationFilterLists.h"

#include "Conversion/Guarded.h"
#include "Conversion/Legend.h"
#include "Conversion/OutputGridErrors.h"
#include "Conversion/OutputSurfaces.h"

#include "Extract/Extract.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataMaterialInterfaces);

int vtkStrataMaterialInterfaces::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkStrataMaterialInterfaces::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* output = vtkPartitionedDataSetCollection::GetData(outputs);
  return conversion::guarded(this, output, [&](strata::Progress& progress) {
    this->CheckMinimumVolumeFraction();
    conversion::SimulationOptions options = this->ArrayLists->options(*this);
    options.readFields = false;
    const conversion::CaseData input = conversion::splitCase(vtkDataObject::GetData(inputs[0]));
    const conversion::ReadSimulationResult read = conversion::readSimulation(input, options);
    conversion::warn(this, read.warnings);
    strata::ExtractOptions extraction;
    extraction.volumeCorrection = this->VolumeCorrection;
    extraction.gatherSmearedFractions = this->GatherSmearedFractions;
    extraction.minimumVolumeFraction = this->MinimumVolumeFraction;
    progress.stage("Finding the interfaces", 0.0, 1.0);
    const strata::ExtractedInterfaces found = strata::extractInterfaces(read.simulation, extraction, progress);
    conversion::warn(this, found.warnings);
    conversion::writeInterfaces(found.interfaces, read.simulation.materials, output);
    conversion::writeVolumes(found, output->GetFieldData());
    if (this->VolumeErrors)
    {
      conversion::writeGridErrors(read, found.cellVolumeErrors, output);
    }
    conversion::writeAssembly(read.simulation.materials, output);
  });
}

void vtkStrataMaterialInterfaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VolumeCorrection: " << this->VolumeCorrection << "\n";
  os << indent << "GatherSmearedFractions: " << this->GatherSmearedFractions << "\n";
  os << indent << "VolumeErrors: " << this->VolumeErrors << "\n";
}

std::string vtkStrataMaterialInterfaces::GetLegend()
{
  return conversion::legendOf(this->GetOutputDataObject(0));
}
