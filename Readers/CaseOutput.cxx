#include "CaseOutput.h"

#include "ReadFiles.h"

#include "Conversion/OutputSurfaces.h"
#include "Conversion/ReadSimulation.h"
#include "Conversion/ValueConversion.h"

#include "Extract/Extract.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkPartitionedDataSetCollection.h>

#include <algorithm>

namespace conversion = strata::conversion;

namespace
{
/// The data sets that a grid file holds: a composite's blocks, or itself.
std::vector<vtkSmartPointer<vtkDataObject>> partsOf(vtkDataObject* grid)
{
  std::vector<vtkSmartPointer<vtkDataObject>> parts;
  auto* composite = vtkCompositeDataSet::SafeDownCast(grid);
  if (!composite)
  {
    parts.emplace_back(grid);
    return parts;
  }
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    parts.emplace_back(iterator->GetCurrentDataObject());
  }
  return parts;
}

void collectNames(vtkFieldData* data, std::vector<std::string>& names)
{
  for (int i = 0; data && i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    if (name && std::find(names.begin(), names.end(), name) == names.end())
    {
      names.emplace_back(name);
    }
  }
}

/// Throws where the grid lacks an array that the case names.
void expectArrays(
  const std::vector<vtkSmartPointer<vtkDataObject>>& parts, const CaseFile& file, const std::string& grid)
{
  std::vector<std::string> present;
  for (vtkDataObject* part : parts)
  {
    collectNames(part->GetAttributesAsFieldData(vtkDataObject::CELL), present);
    collectNames(part->GetAttributesAsFieldData(vtkDataObject::POINT), present);
  }
  const auto expect = [&](const std::string& name) {
    if (!name.empty() && std::find(present.begin(), present.end(), name) == present.end())
    {
      throw strata::InvalidInput(
        "The grid '" + grid + "' has no array '" + name + "'. Arrays: " + conversion::listed(present));
    }
  };
  for (const std::string& name : file.description.fractionArrays)
  {
    expect(name);
  }
  for (const conversion::CaseField& field : file.description.fields)
  {
    expect(field.array);
  }
}

void addGrid(const CaseFile& file, const CaseFile::Step& step, vtkPartitionedDataSetCollection* output)
{
  const std::vector<vtkSmartPointer<vtkDataObject>> parts = partsOf(readGridFile(step.grid));
  expectArrays(parts, file, step.grid);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    conversion::describeCase(file.description, parts[i]->GetFieldData());
    output->SetPartition(0, static_cast<unsigned int>(i), parts[i]);
  }
  output->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), conversion::names::grid);
}

strata::MaterialId materialOf(const std::string& name, const strata::Materials& materials)
{
  const auto at = std::find_if(
    materials.begin(), materials.end(), [&](const strata::Material& material) { return material.name == name; });
  return strata::MaterialId(at - materials.begin());
}

void addSurfaces(const CaseFile& file, const CaseFile::Step& step, vtkPartitionedDataSetCollection* output)
{
  const strata::Materials& materials = file.description.materials;
  for (const CaseFile::Surface& surface : step.interfaces)
  {
    const vtkSmartPointer<vtkPolyData> data = readSurfaceFile(surface.path);
    conversion::labelSurface(
      data, materialOf(surface.positive, materials), materialOf(surface.negative, materials), materials);
    const unsigned int block = output->GetNumberOfPartitionedDataSets();
    output->SetPartition(block, 0, data);
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), (surface.positive + "|" + surface.negative).c_str());
  }
}

/// Finds the surfaces from the fractions; returns the materials, `outside` among them where there is any.
strata::Materials addFoundSurfaces(
  vtkPartitionedDataSetCollection* output, strata::Warnings& warnings, strata::Progress& progress)
{
  conversion::SimulationOptions options;
  options.readFields = false;
  const auto read = conversion::readSimulation(conversion::splitCase(output), options);
  const strata::ExtractedInterfaces found = strata::extractInterfaces(read.simulation, {}, progress);
  conversion::writeInterfaces(found.interfaces, read.simulation.materials, output);
  warnings = read.warnings;
  warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
  return read.simulation.materials;
}
}

strata::Warnings readStep(
  const CaseFile& file, const CaseFile::Step& step, vtkPartitionedDataSetCollection* output, strata::Progress& progress)
{
  strata::Warnings warnings;
  strata::Materials materials = file.description.materials;
  progress.stage("Reading the grid", 0.0, 0.5);
  addGrid(file, step, output);
  progress.stage("Reading the interfaces", 0.5, 1.0);
  if (step.hasInterfaces)
  {
    addSurfaces(file, step, output);
  }
  else
  {
    materials = addFoundSurfaces(output, warnings, progress);
  }
  conversion::writeAssembly(materials, output);
  return warnings;
}
