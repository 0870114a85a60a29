#include "OriginalInterfaces.h"

#include "Conversion/InputSurfaces.h"

#include "Build/SurfaceEdges.h"
#include <sstream>

namespace conversion = strata::conversion;

namespace
{
/// Says where surfaces that somebody made leave it open what lies on which side.
void warnOfGaps(const strata::Interfaces& interfaces, const strata::Simulation& simulation, strata::Warnings& warnings)
{
  const auto count = static_cast<strata::Index>(simulation.materials.size());
  for (const strata::OpenBorder& border : strata::openBorders(interfaces, count, strata::bounds(simulation.grid)))
  {
    const strata::Vector& lower = border.lower;
    const strata::Vector& upper = border.upper;
    std::ostringstream text;
    text << "The interfaces round '" << simulation.materials[static_cast<std::size_t>(border.material.value)].name
         << "' are open along " << border.edges << " edges of length " << border.length
         << " within the box; the longest gap goes from (" << lower[0] << ", " << lower[1] << ", " << lower[2]
         << ") to (" << upper[0] << ", " << upper[1] << ", " << upper[2] << "), and the material may be wrong up to "
         << border.reach << " from its edges: sides follow winding numbers there";
    warnings.push_back(text.str());
  }
}
}

strata::ExtractOptions extractOptions(double minimumVolumeFraction)
{
  strata::ExtractOptions options;
  options.minimumVolumeFraction = minimumVolumeFraction;
  return options;
}

strata::Interfaces originalInterfaces(const conversion::CaseData& input, vtkDataObject* given,
  const strata::Simulation& simulation, double minimumVolumeFraction, strata::Warnings& warnings,
  strata::Progress& progress)
{
  if (given || !input.surfaces.empty())
  {
    strata::Interfaces read = conversion::readInterfaces(
      given ? conversion::surfacesOf(given) : input.surfaces, simulation.materials, warnings);
    warnOfGaps(read, simulation, warnings);
    return read;
  }
  strata::ExtractedInterfaces found =
    strata::extractInterfaces(simulation, extractOptions(minimumVolumeFraction), progress);
  warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
  return std::move(found.interfaces);
}
