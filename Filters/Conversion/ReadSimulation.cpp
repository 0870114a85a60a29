#include "Conversion/ReadSimulation.h"

#include "Conversion/InputFields.h"
#include "Conversion/InputMaterials.h"
#include "Conversion/LabelImages.h"

#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkPolyData.h>

#include <limits>

namespace strata::conversion
{
ReadSimulationResult readSimulation(const CaseData& input, const SimulationOptions& options)
{
  if (!input.grid)
  {
    throw InvalidInput("There is no input grid");
  }
  ReadSimulationResult result;
  result.source = readGrid(withLabelsInCells(input.grid, options));
  result.warnings = result.source.warnings;
  const MaterialRoles roles =
    readMaterials(result.source, input.description, options, result.simulation, result.warnings);
  result.deviations.fields =
    readFields(result.source, input.description, options, roles, result.simulation, result.warnings);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  result.deviations.places = result.source.hasUnboundedCurves ? infinity : result.source.placeDeviation;
  for (std::size_t f = 0; f < result.simulation.fields.size() && result.source.hasUnboundedCurves; ++f)
  {
    const bool isCurved = result.simulation.fields[f].association == Association::Points;
    result.deviations.fields[f] = isCurved ? infinity : result.deviations.fields[f];
  }
  result.simulation.grid = std::move(result.source.grid);
  return result;
}
}
