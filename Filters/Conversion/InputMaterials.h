#pragma once

#include "Conversion/ReadSimulation.h"

namespace strata::conversion
{
/// Which arrays say where the materials are; they are no fields.
struct MaterialRoles
{
  std::vector<std::string> arrays;
};

/// Finds the materials of an input: the case's, the arrays that the user names, those recognized by their names,
/// an array of ids, or a single material. Fills `materials`, `fractions` or `materialIds` of the simulation.
MaterialRoles readMaterials(const InputGrid& input, const CaseDescription& description,
  const SimulationOptions& options, Simulation& simulation, Warnings& warnings);
}
