#include "Conversion/ValueConversion.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArrayRange.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>

namespace strata::conversion
{
namespace
{
/// Copies all values of an array of any type.
template<typename T>
struct Copy
{
  std::vector<T> values;

  template<typename Array>
  void operator()(Array* array)
  {
    const auto range = vtk::DataArrayValueRange(array);
    values.resize(static_cast<std::size_t>(range.size()));
    auto to = values.begin();
    for (const auto value : range)
    {
      *to++ = static_cast<T>(value);
    }
  }
};

template<typename T>
std::vector<T> copyOf(vtkDataArray* array)
{
  Copy<T> copy;
  if (!vtkArrayDispatch::Dispatch::Execute(array, copy))
  {
    copy(array);
  }
  return std::move(copy.values);
}

std::shared_ptr<const void> owner(vtkDataArray* array)
{
  return std::make_shared<vtkSmartPointer<vtkDataArray>>(array);
}
}

ValueArray valuesOf(vtkDataArray* array)
{
  const Index tuples = array->GetNumberOfTuples();
  const int components = array->GetNumberOfComponents();
  if (auto* floats = vtkFloatArray::FastDownCast(array); floats && tuples > 0)
  {
    return ValueArray(floats->GetPointer(0), tuples, components, owner(array));
  }
  if (auto* doubles = vtkDoubleArray::FastDownCast(array); doubles && tuples > 0)
  {
    return ValueArray(doubles->GetPointer(0), tuples, components, owner(array));
  }
  return ownedValues(copyOf<double>(array), components);
}

std::vector<std::int64_t> integersOf(vtkDataArray* array)
{
  return copyOf<std::int64_t>(array);
}

std::vector<Vector> positionsOf(vtkPoints* points)
{
  std::vector<Vector> result;
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return result;
  }
  const ValueArray values = valuesOf(points->GetData());
  result.reserve(static_cast<std::size_t>(values.tuples()));
  for (Index i = 0; i < values.tuples(); ++i)
  {
    result.emplace_back(values(i, 0), values(i, 1), values(i, 2));
  }
  return result;
}

vtkSmartPointer<vtkStringArray> stringArray(const std::string& name, const std::vector<std::string>& values)
{
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name.c_str());
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

std::vector<std::string> stringsOf(vtkFieldData* data, const std::string& name)
{
  std::vector<std::string> result;
  auto* array = data ? vtkStringArray::SafeDownCast(data->GetAbstractArray(name.c_str())) : nullptr;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    result.push_back(array->GetValue(i));
  }
  return result;
}

std::string listed(const std::vector<std::string>& names)
{
  std::string result;
  for (const std::string& name : names)
  {
    result += (result.empty() ? "'" : ", '") + name + "'";
  }
  return result.empty() ? "none" : result;
}
}
