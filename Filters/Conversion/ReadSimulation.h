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
  bool blocksAsMaterials = false;
  std::string remainderMaterial = "empty";
  std::vector<std::string> materialsWithoutFields;
  std::vector<std::string> fieldArrays;
  bool readFields = true; ///< off: the fields' values are left out
};

/// How far the data may lie from what errors are measured against, where curved cells are cut into linear ones:
/// lengths, and one number per field in its unit. Infinite where there is no bound, 0 where there are no curved cells.
struct Deviations
{
  double places = 0.0;
  std::vector<double> fields;
};

/// A simulation ready for the core, and what there is to tell about it.
struct ReadSimulationResult
{
  Simulation simulation;
  InputGrid source; ///< its grid is empty: it moved into the simulation
  Deviations deviations;
  Warnings warnings;
};

/// Reads the grid, the materials and the fields of an input (design 4). Float and double arrays are viewed, not
/// copied. Throws InvalidInput that names the thing and its value.
ReadSimulationResult readSimulation(const CaseData& input, const SimulationOptions& options);
}
