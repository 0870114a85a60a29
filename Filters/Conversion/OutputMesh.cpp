#include "Conversion/OutputMesh.h"

#include "Conversion/CaseData.h"
#include "Conversion/ValueConversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

namespace strata::conversion
{
namespace
{
template<typename VtkArray, typename T>
void add(vtkDataSetAttributes* data, const std::string& name, Buffer<T>& buffer, int components = 1)
{
  if (buffer.size() > 0)
  {
    data->AddArray(give<VtkArray>(name, std::move(buffer), components));
  }
}

void writePointData(Mesh& mesh, vtkPointData* data)
{
  add<vtkIntArray>(data, "material", mesh.vertexMaterial);
  for (std::size_t f = 0; f < mesh.composite.size(); ++f)
  {
    add<vtkFloatArray>(data, mesh.fields[f].name, mesh.composite[f], mesh.fields[f].components);
  }
  for (std::size_t m = 0; m < mesh.distances.size(); ++m)
  {
    add<vtkFloatArray>(data, "distance_" + mesh.materials[m].name, mesh.distances[m]);
  }
  for (std::size_t f = 0; f < mesh.values.size(); ++f)
  {
    for (std::size_t m = 0; m < mesh.values[f].size(); ++m)
    {
      add<vtkFloatArray>(
        data, mesh.fields[f].name + "_" + mesh.materials[m].name, mesh.values[f][m], mesh.fields[f].components);
    }
  }
  for (std::size_t m = 0; m < mesh.ghosts.size(); ++m)
  {
    add<vtkUnsignedCharArray>(data, "ghost_" + mesh.materials[m].name, mesh.ghosts[m]);
  }
  if (!mesh.fields.empty())
  {
    data->SetActiveScalars(mesh.fields.front().name.c_str());
  }
}

void writeCellData(Mesh& mesh, vtkCellData* data)
{
  add<vtkIntArray>(data, "material", mesh.cellMaterial);
  add<vtkIntArray>(data, "level", mesh.cellLevel);
  add<vtkFloatArray>(data, "interface_error", mesh.cellInterfaceError);
  for (std::size_t f = 0; f < mesh.cellFieldErrors.size(); ++f)
  {
    add<vtkFloatArray>(data, "field_error_" + mesh.fields[f].name, mesh.cellFieldErrors[f]);
  }
}

void addNumber(vtkFieldData* data, const std::string& name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  data->AddArray(array);
}

void writeFieldData(const Mesh& mesh, vtkFieldData* data)
{
  writeMaterials(mesh.materials, data);
  std::vector<std::string> fieldNames;
  for (std::size_t f = 0; f < mesh.fields.size(); ++f)
  {
    fieldNames.push_back(mesh.fields[f].name);
    if (f < mesh.achieved.fieldErrors.size())
    {
      addNumber(data, "achieved_field_error_" + mesh.fields[f].name, mesh.achieved.fieldErrors[f]);
    }
  }
  data->AddArray(stringArray(names::fields, fieldNames));
  addNumber(data, "achieved_interface_error", mesh.achieved.interfaceError);
  if (mesh.achieved.regionError)
  {
    addNumber(data, "achieved_region_error", *mesh.achieved.regionError);
  }
  vtkNew<vtkUnsignedCharArray> boundMet;
  boundMet->SetName("bound_met");
  boundMet->InsertNextValue(mesh.achieved.boundMet ? 1 : 0);
  data->AddArray(boundMet);
  data->AddArray(stringArray("stopped_by", { mesh.achieved.stoppedBy }));
}
}

void writeMesh(Mesh&& mesh, vtkUnstructuredGrid* output)
{
  writeFieldData(mesh, output->GetFieldData());
  writePointData(mesh, output->GetPointData());
  writeCellData(mesh, output->GetCellData());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(give<vtkDoubleArray>("Points", std::move(mesh.points), 3));
  output->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->SetData(4, give<vtkTypeInt64Array>("", std::move(mesh.tetrahedra)));
  output->SetCells(VTK_TETRA, cells);
}

void writeDeviations(const Deviations& deviations, const std::vector<Field>& fields, vtkUnstructuredGrid* output)
{
  if (deviations.places == 0.0)
  {
    return;
  }
  addNumber(output->GetFieldData(), "not_in_interface_error", deviations.places);
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    addNumber(output->GetFieldData(), "not_in_field_error_" + fields[f].name, deviations.fields[f]);
  }
}
}
