#include "Conversion/Legend.h"

#include "Conversion/CaseData.h"
#include "Conversion/MaterialNames.h"
#include "Conversion/ValueConversion.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkCompositeDataSetRange.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace strata::conversion
{
namespace
{
constexpr int fewPairs = 10;

/// A data object's parts, or itself where it has none; nothing for null.
std::vector<vtkDataObject*> objectsOf(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return data ? std::vector<vtkDataObject*>{ data } : std::vector<vtkDataObject*>{};
  }
  std::vector<vtkDataObject*> result;
  for (vtkDataObject* leaf : vtk::Range(composite, vtk::CompositeDataSetOptions::SkipEmptyNodes))
  {
    result.push_back(leaf);
  }
  return result;
}

std::vector<vtkDataSet*> leavesOf(vtkDataObject* data)
{
  std::vector<vtkDataSet*> result;
  for (vtkDataObject* leaf : objectsOf(data))
  {
    if (auto* dataSet = vtkDataSet::SafeDownCast(leaf))
    {
      result.push_back(dataSet);
    }
  }
  return result;
}

/// The numbers in a cell array of the leaves; whether there is such an array at all.
bool valuesIn(const std::vector<vtkDataSet*>& leaves, const char* name, std::set<int>& values)
{
  bool found = false;
  for (vtkDataSet* leaf : leaves)
  {
    auto* array = vtkIntArray::FastDownCast(leaf->GetCellData()->GetArray(name));
    found = found || array;
    int last = -2;
    for (vtkIdType cell = 0; array && cell < array->GetNumberOfTuples(); ++cell)
    {
      const int value = array->GetValue(cell);
      if (value != last)
      {
        values.insert(value);
        last = value;
      }
    }
  }
  return found;
}

std::vector<std::string> materialsToChoose(vtkDataObject* input)
{
  std::vector<std::string> result = stringsOf(input ? input->GetFieldData() : nullptr, names::materials);
  if (!result.empty())
  {
    return result;
  }
  for (vtkDataObject* leaf : objectsOf(input))
  {
    for (const int association : { vtkDataObject::CELL, vtkDataObject::POINT })
    {
      vtkDataSetAttributes* arrays = leaf->GetAttributes(association);
      for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
      {
        const char* name = arrays->GetArrayName(i);
        const auto material = materialOfFractions(name ? name : "");
        if (material && std::find(result.begin(), result.end(), *material) == result.end())
        {
          result.push_back(*material);
        }
      }
    }
  }
  return result;
}

std::string pairsLegend(const Materials& materials, const std::set<int>& present)
{
  const int count = static_cast<int>(materials.size());
  std::ostringstream lines;
  for (int a = 0; a < count; ++a)
  {
    for (int b = a + 1; b < count; ++b)
    {
      const int pair = pairNumber(a, b, count);
      if (count * (count - 1) / 2 <= fewPairs || present.count(pair) > 0)
      {
        lines << pair << "\t" << materials[static_cast<std::size_t>(a)].name << " / "
              << materials[static_cast<std::size_t>(b)].name << "\n";
      }
    }
  }
  return lines.str();
}
}

std::string legendOf(vtkDataObject* output)
{
  const Materials materials = readMaterials(output ? output->GetFieldData() : nullptr);
  const std::vector<vtkDataSet*> leaves = leavesOf(output);
  std::set<int> present;
  if (valuesIn(leaves, names::pair, present))
  {
    return pairsLegend(materials, present);
  }
  valuesIn(leaves, names::material, present);
  std::ostringstream lines;
  if (present.count(-1) > 0)
  {
    lines << "-1\tseveral\n";
  }
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    lines << m << "\t" << materials[m].name << (materials[m].hasFields ? "\n" : "\tplain\n");
  }
  return lines.str();
}

std::string materialNamesOf(vtkDataObject* output)
{
  std::string result;
  for (const std::string& name : stringsOf(output ? output->GetFieldData() : nullptr, names::materials))
  {
    result += (result.empty() ? "" : ", ") + name;
  }
  return result;
}

void listInputMaterials(vtkAlgorithm* filter, vtkStringArray* names)
{
  vtkDataObject* input = filter->GetNumberOfInputConnections(0) > 0 ? filter->GetInputDataObject(0, 0) : nullptr;
  names->Initialize();
  for (const std::string& name : materialsToChoose(input))
  {
    names->InsertNextValue(name);
  }
}
}
