#include "vtkStrataMaterialsFilter.h"

#include "MaterialsFilterLists.h"

#include "Conversion/Legend.h"

#include "vtkInformation.h"
#include "vtkStringArray.h"

vtkStrataMaterialsFilter::vtkStrataMaterialsFilter() : MaterialLists(new Lists) {}

vtkStrataMaterialsFilter::~vtkStrataMaterialsFilter() = default;

void vtkStrataMaterialsFilter::AddMaterial(const char* name)
{
  if (name && *name)
  {
    this->MaterialLists->materials.emplace_back(name);
    this->Modified();
  }
}

void vtkStrataMaterialsFilter::ClearMaterials()
{
  this->MaterialLists->materials.clear();
  this->Modified();
}

vtkStringArray* vtkStrataMaterialsFilter::GetInputMaterials()
{
  strata::conversion::listInputMaterials(this, this->InputMaterials);
  return this->InputMaterials;
}

int vtkStrataMaterialsFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}
