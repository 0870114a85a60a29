#include "Conversion/CaseData.h"

#include "Conversion/ValueConversion.h"

#include "Model/Errors.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace strata::conversion
{
namespace
{
std::string blockName(vtkPartitionedDataSetCollection* collection, unsigned int block)
{
  const char* name =
    collection->HasMetaData(block) ? collection->GetMetaData(block)->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

vtkFieldData* describedFieldData(vtkDataObject* grid)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(grid))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkFieldData* data = iterator->GetCurrentDataObject()->GetFieldData();
      if (data && data->GetAbstractArray(names::caseFractions))
      {
        return data;
      }
    }
  }
  return grid ? grid->GetFieldData() : nullptr;
}
}

void writeMaterials(const Materials& materials, vtkFieldData* data)
{
  std::vector<std::string> materialNames;
  vtkNew<vtkUnsignedCharArray> hasFields;
  hasFields->SetName(names::hasFields);
  for (const Material& material : materials)
  {
    materialNames.push_back(material.name);
    hasFields->InsertNextValue(material.hasFields ? 1 : 0);
  }
  data->AddArray(stringArray(names::materials, materialNames));
  data->AddArray(hasFields);
}

Materials readMaterials(vtkFieldData* data)
{
  Materials materials;
  vtkDataArray* hasFields = data ? data->GetArray(names::hasFields) : nullptr;
  for (const std::string& name : stringsOf(data, names::materials))
  {
    const auto m = static_cast<vtkIdType>(materials.size());
    const bool fields = !hasFields || m >= hasFields->GetNumberOfTuples() || hasFields->GetTuple1(m) != 0.0;
    materials.push_back({ name, fields });
  }
  return materials;
}

void describeCase(const CaseDescription& description, vtkFieldData* data)
{
  writeMaterials(description.materials, data);
  data->AddArray(stringArray(names::caseFractions, description.fractionArrays));
  std::vector<std::string> triples;
  for (const CaseField& field : description.fields)
  {
    triples.insert(triples.end(), { field.field, field.material, field.array });
  }
  data->AddArray(stringArray(names::caseFields, triples));
}

CaseDescription caseDescription(vtkFieldData* data)
{
  CaseDescription result;
  result.fractionArrays = stringsOf(data, names::caseFractions);
  if (result.fractionArrays.empty())
  {
    return result;
  }
  result.materials = readMaterials(data);
  if (result.materials.size() != result.fractionArrays.size())
  {
    throw InvalidInput(
      "The field data '" + std::string(names::caseFractions) + "' doesn't fit '" + names::materials + "'");
  }
  const std::vector<std::string> triples = stringsOf(data, names::caseFields);
  for (std::size_t i = 0; i + 2 < triples.size(); i += 3)
  {
    result.fields.push_back({ triples[i], triples[i + 1], triples[i + 2] });
  }
  return result;
}

std::vector<NamedSurface> surfacesOf(vtkDataObject* input)
{
  std::vector<NamedSurface> result;
  if (auto* surface = vtkPolyData::SafeDownCast(input))
  {
    result.push_back({ "", surface });
    return result;
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    throw InvalidInput(std::string("Interfaces must be surfaces (vtkPolyData), not a ") +
                       (input ? input->GetClassName() : "missing input"));
  }
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(input))
  {
    for (unsigned int block = 0; block < collection->GetNumberOfPartitionedDataSets(); ++block)
    {
      for (unsigned int part = 0; part < collection->GetNumberOfPartitions(block); ++part)
      {
        if (auto* surface = vtkPolyData::SafeDownCast(collection->GetPartitionAsDataObject(block, part)))
        {
          result.push_back({ blockName(collection, block), surface });
        }
      }
    }
    return result;
  }
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (auto* surface = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      const char* name =
        iterator->HasCurrentMetaData() ? iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
      result.push_back({ name ? name : "", surface });
    }
  }
  return result;
}

CaseData splitCase(vtkDataObject* input)
{
  CaseData result;
  result.grid = input;
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(input);
  for (unsigned int block = 0; collection && block < collection->GetNumberOfPartitionedDataSets(); ++block)
  {
    if (blockName(collection, block) == names::grid)
    {
      result.grid = collection->GetPartitionedDataSet(block);
      result.hasSurfaces = true;
      result.surfaces = surfacesOf(input);
    }
  }
  result.description = caseDescription(describedFieldData(result.grid));
  return result;
}

std::uint64_t modifiedTime(vtkDataObject* data)
{
  std::uint64_t latest = data ? data->GetMTime() : 0;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      latest = std::max<std::uint64_t>(latest, iterator->GetCurrentDataObject()->GetMTime());
    }
  }
  return latest;
}
}
