#include "vtkStrataSimulationFilter.h"

#include "SimulationFilterLists.h"

#include "Conversion/Legend.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkStringArray.h"

#include <sstream>

vtkStrataSimulationFilter::vtkStrataSimulationFilter() : ArrayLists(new Lists) {}

vtkStrataSimulationFilter::~vtkStrataSimulationFilter() = default;

void vtkStrataSimulationFilter::AddVolumeFractionArray(const char* name)
{
  if (name && *name)
  {
    this->ArrayLists->volumeFractionArrays.emplace_back(name);
    this->Modified();
  }
}

void vtkStrataSimulationFilter::ClearVolumeFractionArrays()
{
  this->ArrayLists->volumeFractionArrays.clear();
  this->Modified();
}

void vtkStrataSimulationFilter::AddMaterialWithoutFields(const char* name)
{
  if (name && *name)
  {
    this->ArrayLists->materialsWithoutFields.emplace_back(name);
    this->Modified();
  }
}

void vtkStrataSimulationFilter::ClearMaterialsWithoutFields()
{
  this->ArrayLists->materialsWithoutFields.clear();
  this->Modified();
}

void vtkStrataSimulationFilter::CheckMinimumVolumeFraction() const
{
  if (!(this->MinimumVolumeFraction >= 0.0 && this->MinimumVolumeFraction <= 1.0))
  {
    std::ostringstream message;
    message << "MinimumVolumeFraction is " << this->MinimumVolumeFraction << "; it must lie within [0, 1]";
    throw strata::InvalidInput(message.str());
  }
}

vtkStringArray* vtkStrataSimulationFilter::GetInputMaterials()
{
  strata::conversion::listInputMaterials(this, this->InputMaterials);
  return this->InputMaterials;
}

int vtkStrataSimulationFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHyperTreeGrid");
  return 1;
}

void vtkStrataSimulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaterialIdArray: " << this->MaterialIdArray << "\n";
  os << indent << "BlocksAsMaterials: " << this->BlocksAsMaterials << "\n";
  os << indent << "RemainderMaterial: " << this->RemainderMaterial << "\n";
  os << indent << "MinimumVolumeFraction: " << this->MinimumVolumeFraction << "\n";
}

std::string vtkStrataSimulationFilter::GetMaterialNames()
{
  return strata::conversion::materialNamesOf(this->GetOutputDataObject(0));
}
