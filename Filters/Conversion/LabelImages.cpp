#include "Conversion/LabelImages.h"

#include "Conversion/MaterialNames.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

namespace strata::conversion
{
namespace
{
bool isLabels(vtkDataArray* array)
{
  return array && array->GetNumberOfComponents() == 1 && array->GetDataType() != VTK_FLOAT &&
         array->GetDataType() != VTK_DOUBLE;
}

/// Whether an array of a data set says, by its name, where the materials are.
bool saysMaterials(vtkDataSetAttributes* data, bool onlyFractions)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    if (name && (materialOfFractions(name) || (!onlyFractions && isMaterialIdName(name))))
    {
      return true;
    }
  }
  return false;
}

bool hasLabelsAtPoints(vtkImageData* image, const SimulationOptions& options)
{
  vtkPointData* points = image->GetPointData();
  if (!options.volumeFractionArrays.empty() || options.blocksAsMaterials ||
      points->HasArray(vtkDataSetAttributes::GhostArrayName()))
  {
    return false;
  }
  const std::string& named = options.materialIdArray;
  if (!named.empty() && named != "None")
  {
    return !image->GetCellData()->HasArray(named.c_str()) && isLabels(points->GetArray(named.c_str()));
  }
  bool found = false;
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    found = found || (isLabels(array) && array->GetName() && isMaterialIdName(array->GetName()));
  }
  return found && !saysMaterials(image->GetCellData(), false) && !saysMaterials(points, true);
}
}

vtkSmartPointer<vtkDataObject> withLabelsInCells(vtkDataObject* data, const SimulationOptions& options)
{
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image || !hasLabelsAtPoints(image, options))
  {
    return data;
  }
  auto result = vtkSmartPointer<vtkImageData>::New();
  int extent[6];
  image->GetExtent(extent);
  double origin[3];
  double shift[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    ++extent[2 * axis + 1];
    shift[axis] = -0.5 * image->GetSpacing()[axis];
  }
  image->GetDirectionMatrix()->MultiplyPoint(shift, origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] += image->GetOrigin()[axis];
  }
  result->SetExtent(extent);
  result->SetSpacing(image->GetSpacing());
  result->SetOrigin(origin);
  result->SetDirectionMatrix(image->GetDirectionMatrix());
  result->GetCellData()->ShallowCopy(image->GetPointData());
  result->GetFieldData()->ShallowCopy(image->GetFieldData());
  return result;
}
}
