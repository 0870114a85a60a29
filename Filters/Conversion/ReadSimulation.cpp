#include "Conversion/ReadSimulation.h"

#include "Conversion/InputFields.h"
#include "Conversion/InputMaterials.h"

#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkPolyData.h>

namespace strata::conversion
{
ReadSimulationResult readSimulation(const CaseData& input, const SimulationOptions& options)
{
  if (!input.grid)
  {
    throw InvalidInput("There is no input grid");
  }
  ReadSimulationResult result;
  result.source = readGrid(input.grid);
  result.warnings = result.source.warnings;
  const MaterialRoles roles =
    readMaterials(result.source, input.description, options, result.simulation, result.warnings);
  readFields(result.source, input.description, options, roles, result.simulation, result.warnings);
  result.simulation.grid = std::move(result.source.grid);
  return result;
}
}
