#include "Extract/Extract.h"

#include "Extract/Boundary.h"
#include "Extract/FractionInterfaces.h"
#include "Extract/IdInterfaces.h"

namespace strata
{
ExtractedInterfaces extractInterfaces(const Simulation& simulation, const ExtractOptions& options, Progress& progress)
{
  const std::unique_ptr<GridTopology> topology = makeGridTopology(simulation.grid);
  const Boundary boundary(*topology, simulation.materials, bounds(simulation.grid));
  return simulation.materialIds.empty() ? extractFromFractions(simulation, options, *topology, boundary, progress)
                                        : extractFromIds(simulation, *topology, boundary, progress);
}
}
