#include "Conversion/Legend.h"

#include "Conversion/CaseData.h"
#include "Conversion/ValueConversion.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkCompositeDataSetRange.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>

#include <set>
#include <sstream>

namespace strata::conversion
{
namespace
{
constexpr int fewPairs = 10;

void addLeaf(vtkDataObject* leaf, std::vector<vtkDataSet*>& result)
{
  if (auto* data = vtkDataSet::SafeDownCast(leaf))
  {
    result.push_back(data);
  }
}

std::vector<vtkDataSet*> leavesOf(vtkDataObject* data)
{
  std::vector<vtkDataSet*> result;
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    addLeaf(data, result);
    return result;
  }
  for (vtkDataObject* leaf : vtk::Range(composite, vtk::CompositeDataSetOptions::SkipEmptyNodes))
  {
    addLeaf(leaf, result);
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
}
