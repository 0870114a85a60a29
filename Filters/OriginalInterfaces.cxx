#include "OriginalInterfaces.h"

#include "Conversion/InputSurfaces.h"

#include "Extract/Extract.h"

namespace conversion = strata::conversion;

strata::Interfaces originalInterfaces(const conversion::CaseData& input, vtkDataObject* given,
  const strata::Simulation& simulation, double minimumVolumeFraction, strata::Warnings& warnings,
  strata::Progress& progress)
{
  if (given)
  {
    return conversion::readInterfaces(conversion::surfacesOf(given), simulation.materials, warnings);
  }
  if (!input.surfaces.empty())
  {
    return conversion::readInterfaces(input.surfaces, simulation.materials, warnings);
  }
  strata::ExtractOptions options;
  options.minimumVolumeFraction = minimumVolumeFraction;
  strata::ExtractedInterfaces found = strata::extractInterfaces(simulation, options, progress);
  warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
  return std::move(found.interfaces);
}
