#include "vtkStrataMaterialContour.h"

#include "Contour/Contour.h"
#include "Conversion/Guarded.h"
#include "Conversion/InputRepresentation.h"
#include "Conversion/Legend.h"
#include "Conversion/OutputPolygons.h"
#include "MaterialsFilterLists.h"

#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataMaterialContour);

void vtkStrataMaterialContour::SetNumberOfIsosurfaces(int count)
{
  this->Isosurfaces.resize(static_cast<std::size_t>(std::max(count, 0)));
  this->Modified();
}

void vtkStrataMaterialContour::SetIsosurface(int number, double value)
{
  if (number >= 0)
  {
    this->Isosurfaces.resize(std::max(this->Isosurfaces.size(), static_cast<std::size_t>(number) + 1));
    this->Isosurfaces[static_cast<std::size_t>(number)] = value;
    this->Modified();
  }
}

double vtkStrataMaterialContour::GetIsosurface(int number) const
{
  return this->Isosurfaces.at(static_cast<std::size_t>(number));
}

int vtkStrataMaterialContour::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

std::string vtkStrataMaterialContour::FieldName()
{
  vtkInformation* chosen = this->GetInputArrayInformation(0);
  const char* name = chosen->Get(vtkDataObject::FIELD_NAME());
  return name ? name : "";
}

int vtkStrataMaterialContour::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* output = vtkPolyData::GetData(outputs);
  return conversion::guarded(this, output, [&](strata::Progress& progress) {
    const auto input = conversion::readRepresentation(vtkDataObject::GetData(inputs[0]));
    const strata::Representation& mesh = input.view;
    const strata::FieldId field = conversion::chosenField(this->FieldName(), mesh.fields);
    const strata::MaterialSet materials = conversion::chosenMaterials(this->MaterialLists->materials, mesh.materials);
    if (this->Isosurfaces.empty())
    {
      throw strata::InvalidInput("There is no value to contour: add one to Isosurfaces");
    }
    progress.stage("Contouring", 0.0, 1.0);
    conversion::writePolygons(strata::contour(mesh, field, this->Isosurfaces, materials, progress), mesh, output);
  });
}

void vtkStrataMaterialContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Isosurfaces: " << this->Isosurfaces.size() << "\n";
}

std::string vtkStrataMaterialContour::GetLegend()
{
  return conversion::legendOf(this->GetOutputDataObject(0));
}
