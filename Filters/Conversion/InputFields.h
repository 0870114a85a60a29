#pragma once

#include "Conversion/InputMaterials.h"

#include <vector>

namespace strata::conversion
{
/// Finds the chosen fields' arrays (or the default field's), per material where there are arrays named
/// `<field>_<material>`, and settles which materials have fields. Returns for each field how far it may lie from the
/// values read: on curved cells that are cut into linear ones, and where a mean is taken of values that cells don't
/// share.
std::vector<double> readFields(const InputGrid& input, const CaseDescription& description,
  const SimulationOptions& options, const MaterialRoles& roles, Simulation& simulation, Warnings& warnings);
}
