#include "vtkStrataTetrahedra.h"

#include "SimulationFilterLists.h"
#include "TetrahedraState.h"

#include "Conversion/Guarded.h"
#include "Conversion/Legend.h"
#include "Conversion/OutputMesh.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <chrono>

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataTetrahedra);

vtkStrataTetrahedra::vtkStrataTetrahedra() : State(new Internals)
{
  this->SetNumberOfInputPorts(2);
}

vtkStrataTetrahedra::~vtkStrataTetrahedra() = default;

void vtkStrataTetrahedra::AddFieldArray(const char* name)
{
  if (name && *name)
  {
    this->ArrayLists->fieldArrays.emplace_back(name);
    this->Modified();
  }
}

void vtkStrataTetrahedra::ClearFieldArrays()
{
  this->ArrayLists->fieldArrays.clear();
  this->Modified();
}

void vtkStrataTetrahedra::AddAbsoluteFieldErrorBound(const char* field, double bound)
{
  if (field && *field)
  {
    this->State->absoluteBounds.emplace_back(field, bound);
    this->Modified();
  }
}

void vtkStrataTetrahedra::ClearAbsoluteFieldErrorBounds()
{
  this->State->absoluteBounds.clear();
  this->Modified();
}

void vtkStrataTetrahedra::AddFocusMaterial(const char* name)
{
  if (name && *name)
  {
    this->State->focusMaterials.emplace_back(name);
    this->Modified();
  }
}

void vtkStrataTetrahedra::ClearFocusMaterials()
{
  this->State->focusMaterials.clear();
  this->Modified();
}

double vtkStrataTetrahedra::GetAchievedFieldError(int field) const
{
  return this->State->achieved.fieldErrors.at(static_cast<std::size_t>(field));
}

int vtkStrataTetrahedra::GetNumberOfAchievedFieldErrors() const
{
  return static_cast<int>(this->State->achieved.fieldErrors.size());
}

const char* vtkStrataTetrahedra::GetAchievedFieldErrors() const
{
  return this->State->fieldErrorText.c_str();
}

const char* vtkStrataTetrahedra::GetStoppedBy() const
{
  return this->State->achieved.stoppedBy.c_str();
}

int vtkStrataTetrahedra::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkStrataTetrahedra::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

int vtkStrataTetrahedra::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* output = vtkUnstructuredGrid::GetData(outputs);
  Internals& state = *this->State;
  const auto start = std::chrono::steady_clock::now();
  state.achieved = {};
  const int done = conversion::guarded(this, output, [&](strata::Progress& progress) {
    Internals::Guard guard(state);
    const Internals::Inputs input{ vtkDataObject::GetData(inputs[0]), vtkDataObject::GetData(inputs[1]) };
    this->CheckMinimumVolumeFraction();
    if (state.prepare(*this, input, progress))
    {
      ++this->NumberOfBuilds;
      this->NumberOfExtractions = state.interfaces.extractions();
      conversion::warn(this, state.warnings);
    }
    strata::Mesh mesh = state.multiresolution->level(state.selection(*this), progress, state.emission(*this));
    state.report(mesh);
    conversion::writeMesh(std::move(mesh), output);
    conversion::writeDeviations(state.deviations, state.native->fields(), output);
    guard.done();
  });
  this->AchievedInterfaceError = state.achieved.interfaceError;
  this->BoundMet = done && output->GetNumberOfCells() > 0 && state.achieved.boundMet;
  this->NumberOfCells = output->GetNumberOfCells();
  this->Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return done;
}

void vtkStrataTetrahedra::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InterfaceErrorBound: " << this->InterfaceErrorBound << "\n";
  os << indent << "FieldErrorBound: " << this->FieldErrorBound << "\n";
  os << indent << "FinestInterfaceErrorBound: " << this->FinestInterfaceErrorBound << "\n";
  os << indent << "FinestFieldErrorBound: " << this->FinestFieldErrorBound << "\n";
  os << indent << "LimitCells: " << this->LimitCells << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "NativeElements: " << this->NativeElements << "\n";
  os << indent << "DistanceMethod: " << this->DistanceMethod << "\n";
  os << indent << "GhostMethod: " << this->GhostMethod << "\n";
  os << indent << "ErrorMethod: " << this->ErrorMethod << "\n";
  os << indent << "PassArrays: " << this->PassArrays << "\n";
  os << indent << "RegionOfInterest: " << this->RegionOfInterest << "\n";
  os << indent << "ViewDependent: " << this->ViewDependent << "\n";
  os << indent << "NumberOfCells: " << this->NumberOfCells << "\n";
  os << indent << "StoppedBy: " << this->GetStoppedBy() << "\n";
}

std::string vtkStrataTetrahedra::GetLegend()
{
  return conversion::legendOf(this->GetOutputDataObject(0));
}
