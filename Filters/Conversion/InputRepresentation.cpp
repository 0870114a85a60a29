#include "Conversion/InputRepresentation.h"

#include "Conversion/CaseData.h"
#include "Conversion/ValueConversion.h"

#include <vtkArrayDispatch.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataArrayRange.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace strata::conversion
{
namespace
{
const std::string wanted = "The input is no representation (an output of Multiresolution Tetrahedra): ";

template<typename Array>
const typename Array::ValueType* viewed(vtkDataArray* array, RepresentationInput& input)
{
  using Value = typename Array::ValueType;
  if (auto* typed = Array::FastDownCast(array))
  {
    input.owners.push_back(std::make_shared<vtkSmartPointer<vtkDataArray>>(array));
    return typed->GetPointer(0);
  }
  const ValueArray values = valuesOf(array);
  auto copy = std::make_shared<std::vector<Value>>();
  copy->reserve(static_cast<std::size_t>(values.tuples() * values.components()));
  for (Index i = 0; i < values.tuples(); ++i)
  {
    for (int c = 0; c < values.components(); ++c)
    {
      copy->push_back(static_cast<Value>(values(i, c)));
    }
  }
  input.owners.push_back(copy);
  return copy->data();
}

/// A point array as floats; null where it is absent.
const float* pointValues(
  vtkUnstructuredGrid* grid, const std::string& name, int& components, RepresentationInput& input)
{
  vtkDataArray* array = grid->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    return nullptr;
  }
  if (array->GetNumberOfTuples() != grid->GetNumberOfPoints())
  {
    throw InvalidInput(wanted + "the point array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) +
                       " values for " + std::to_string(grid->GetNumberOfPoints()) + " points");
  }
  components = std::max(components, array->GetNumberOfComponents());
  return viewed<vtkFloatArray>(array, input);
}

void readCells(vtkUnstructuredGrid* grid, RepresentationInput& input)
{
  Representation& view = input.view;
  view.vertexCount = grid->GetNumberOfPoints();
  view.cellCount = grid->GetNumberOfCells();
  if (view.cellCount == 0)
  {
    return;
  }
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  for (Index cell = 0; cell < view.cellCount; ++cell)
  {
    if (types->GetValue(cell) != VTK_TETRA)
    {
      throw InvalidInput(wanted + "cell " + std::to_string(cell) + " is no tetrahedron");
    }
  }
  vtkDataArray* connectivity = grid->GetCells()->GetConnectivityArray();
  if (connectivity->GetNumberOfValues() != 4 * view.cellCount)
  {
    throw InvalidInput(wanted + "its tetrahedra don't have four points each");
  }
  auto corners = std::make_shared<std::vector<std::int64_t>>();
  auto* own = vtkTypeInt64Array::FastDownCast(connectivity);
  if (own)
  {
    view.tetrahedra = reinterpret_cast<const std::int64_t*>(own->GetPointer(0));
    input.owners.push_back(std::make_shared<vtkSmartPointer<vtkDataArray>>(connectivity));
  }
  else
  {
    *corners = integersOf(connectivity);
    view.tetrahedra = corners->data();
    input.owners.push_back(corners);
  }
  const std::int64_t* end = view.tetrahedra + 4 * view.cellCount;
  const std::int64_t* bad =
    std::find_if(view.tetrahedra, end, [&](std::int64_t v) { return v < 0 || v >= view.vertexCount; });
  if (bad != end)
  {
    throw InvalidInput("Cell " + std::to_string((bad - view.tetrahedra) / 4) + " uses point " + std::to_string(*bad) +
                       " of " + std::to_string(view.vertexCount));
  }
}

void readArrays(vtkUnstructuredGrid* grid, RepresentationInput& input)
{
  Representation& view = input.view;
  int one = 1;
  bool any = false;
  for (const Material& material : view.materials)
  {
    view.distances.push_back(pointValues(grid, "distance_" + material.name, one, input));
    any = any || view.distances.back();
  }
  if (!any)
  {
    throw InvalidInput(
      wanted + "it has no point arrays 'distance_<material>'. Was it made with PassArrays 'Composite only'?");
  }
  for (const std::string& name : stringsOf(grid->GetFieldData(), names::fields))
  {
    Field field{ name, 1 };
    view.values.emplace_back();
    for (const Material& material : view.materials)
    {
      view.values.back().push_back(pointValues(grid, name + "_" + material.name, field.components, input));
    }
    view.fields.push_back(field);
  }
}
}

RepresentationInput readRepresentation(vtkDataObject* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid)
  {
    throw InvalidInput(wanted + "it is a " + (data ? data->GetClassName() : "missing input"));
  }
  RepresentationInput input;
  input.view.materials = readMaterials(grid->GetFieldData());
  if (input.view.materials.empty() || input.view.materials.size() > static_cast<std::size_t>(MaterialSet::capacity))
  {
    throw InvalidInput(wanted + "its field data lack '" + names::materials + "'");
  }
  readCells(grid, input);
  if (grid->GetNumberOfPoints() > 0)
  {
    input.view.points = viewed<vtkDoubleArray>(grid->GetPoints()->GetData(), input);
  }
  readArrays(grid, input);
  return input;
}

MaterialSet chosenMaterials(const std::vector<std::string>& chosen, const Materials& materials)
{
  MaterialSet result;
  std::vector<std::string> known;
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    known.push_back(materials[m].name);
    if (chosen.empty() ? materials[m].hasFields : std::find(chosen.begin(), chosen.end(), known.back()) != chosen.end())
    {
      result.insert(MaterialId(static_cast<std::int64_t>(m)));
    }
  }
  for (const std::string& name : chosen)
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      throw InvalidInput("There is no material '" + name + "'. Materials: " + listed(known));
    }
  }
  return result;
}

FieldId chosenField(const std::string& name, const std::vector<Field>& fields)
{
  std::vector<std::string> known;
  for (const Field& field : fields)
  {
    known.push_back(field.name);
  }
  const auto found = std::find(known.begin(), known.end(), name);
  if (known.empty() || (!name.empty() && found == known.end()))
  {
    throw InvalidInput(
      "There is no field '" + name + "' in the representation. Choose one of its fields: " + listed(known));
  }
  return FieldId(name.empty() ? 0 : found - known.begin());
}
}
