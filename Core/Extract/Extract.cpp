#include "Extract/Extract.h"

#include "Extract/Boundary.h"
#include "Extract/FractionInterfaces.h"
#include "Extract/IdInterfaces.h"

namespace strata
{
ExtractedInterfaces extractInterfaces(const Simulation& simulation, const ExtractOptions& options, Progress& progress)
{
  const std::unique_ptr<GridTopology> topology = makeGridTopology(simulation.grid, progress);
  const Boundary boundary(*topology, simulation.materials, bounds(simulation.grid));
  ExtractedInterfaces result = simulation.materialIds.empty()
                                 ? extractFromFractions(simulation, options, *topology, boundary, progress)
                                 : extractFromIds(simulation, *topology, boundary, progress);
  result.warnings.insert(result.warnings.begin(), topology->warnings().begin(), topology->warnings().end());
  return result;
}
}
