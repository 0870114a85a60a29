#pragma once

#include "Geometry/Vector.h"
#include "Model/Buffer.h"
#include "Model/ValueArray.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkSmartPointer.h>

#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkFieldData;
class vtkPoints;
class vtkStringArray;

namespace strata::conversion
{
/// The values of an array: float and double arrays in their own memory, which the result keeps alive, others
/// converted to double.
ValueArray valuesOf(vtkDataArray* array);

/// An array's values as integers.
std::vector<std::int64_t> integersOf(vtkDataArray* array);

/// The coordinates of points.
std::vector<Vector> positionsOf(vtkPoints* points);

/// A named VTK array that takes over a buffer's memory.
template<typename VtkArray, typename T>
vtkSmartPointer<VtkArray> give(const std::string& name, Buffer<T>&& buffer, int components = 1)
{
  using Value = typename VtkArray::ValueType;
  static_assert(sizeof(Value) == sizeof(T), "the buffer's values must have the array's size");
  auto array = vtkSmartPointer<VtkArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  const vtkIdType size = buffer.size();
  array->SetArray(reinterpret_cast<Value*>(buffer.release()), size, 0, VtkArray::VTK_DATA_ARRAY_DELETE);
  return array;
}

/// Memory for an array, owned together by a ValueArray that views it.
template<typename T>
ValueArray ownedValues(std::vector<T>&& values, int components = 1)
{
  auto owner = std::make_shared<std::vector<T>>(std::move(values));
  return ValueArray(owner->data(), static_cast<Index>(owner->size()) / components, components, owner);
}

vtkSmartPointer<vtkStringArray> stringArray(const std::string& name, const std::vector<std::string>& values);

/// The strings of a field data array; empty if there is none of that name.
std::vector<std::string> stringsOf(vtkFieldData* data, const std::string& name);

/// "a, b, c" for messages; "none" if there are none.
std::string listed(const std::vector<std::string>& names);
}
