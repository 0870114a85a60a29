#include "vtkStrataMaterialInterfaces.h"

#include "InterfaceFingerprint.h"
#include "SimulationFilterLists.h"

#include "Conversion/Guarded.h"
#include "Conversion/Legend.h"
#include "Conversion/OutputGridErrors.h"
#include "Conversion/OutputSurfaces.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataMaterialInterfaces);

/// What was found last, for as long as what it follows from stays.
struct vtkStrataMaterialInterfaces::Internals
{
  std::uint64_t fingerprint = 0;
  bool hasCellErrors = false; ///< which take much memory, and are kept only if they were asked for
  std::unique_ptr<strata::ExtractedInterfaces> found;
  int extractions = 0;

  const strata::ExtractedInterfaces& find(const strata::Simulation& simulation, const strata::ExtractOptions& options,
    bool cellErrors, strata::Progress& progress)
  {
    const std::uint64_t wanted = fingerprintOf(simulation, options);
    if (!found || fingerprint != wanted || (cellErrors && !hasCellErrors))
    {
      found.reset();
      found = std::make_unique<strata::ExtractedInterfaces>(strata::extractInterfaces(simulation, options, progress));
      fingerprint = wanted;
      hasCellErrors = cellErrors;
      if (!cellErrors)
      {
        found->cellVolumeErrors = {};
      }
      ++extractions;
    }
    return *found;
  }
};

vtkStrataMaterialInterfaces::vtkStrataMaterialInterfaces() : State(new Internals) {}

vtkStrataMaterialInterfaces::~vtkStrataMaterialInterfaces() = default;

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
    const strata::ExtractedInterfaces& found =
      this->State->find(read.simulation, extraction, this->VolumeErrors, progress);
    this->NumberOfExtractions = this->State->extractions;
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
