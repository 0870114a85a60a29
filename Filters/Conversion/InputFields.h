#pragma once

#include "Conversion/InputMaterials.h"

namespace strata::conversion
{
/// Finds the chosen fields' arrays (or the default field's), per material where there are arrays named
/// `<field>_<material>`, and settles which materials have fields.
void readFields(const InputGrid& input, const CaseDescription& description, const SimulationOptions& options,
  const MaterialRoles& roles, Simulation& simulation, Warnings& warnings);
}
