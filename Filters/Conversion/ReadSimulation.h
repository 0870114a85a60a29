#pragma once

#include "Conversion/CaseData.h"
#include "Conversion/InputGrid.h"

#include "Model/Simulation.h"

#include <string>
#include <vector>

namespace strata::conversion
{
/// What a user says about the arrays of an input; what stays empty is found by the conventions of the codes.
struct SimulationOptions
{
  std::vector<std::string> volumeFractionArrays;
  std::string materialIdArray;
  std::string remainderMaterial = "empty";
  std::vector<std::string> materialsWithoutFields;
  std::vector<std::string> fieldArrays;
  bool readFields = true; ///< off: the fields' values are left out
};

/// A simulation ready for the core, and what there is to tell about it.
struct ReadSimulationResult
{
  Simulation simulation;
  InputGrid source; ///< its grid is empty: it moved into the simulation
  Warnings warnings;
};

/// Reads the grid, the materials and the fields of an input (design 4). Float and double arrays are viewed, not
/// copied. Throws InvalidInput that names the thing and its value.
ReadSimulationResult readSimulation(const CaseData& input, const SimulationOptions& options);
}
