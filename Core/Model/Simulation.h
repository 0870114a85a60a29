#pragma once

#include "Model/Grid.h"
#include "Model/Materials.h"
#include "Model/ValueArray.h"

#include <string>
#include <vector>

namespace strata
{
/// Where the values of an array live.
enum class Association : std::uint8_t
{
  Cells,
  Points
};

/// A field of the simulation: a scalar, vector or tensor per material.
struct SimulationField
{
  std::string name;
  int components = 1;
  Association association = Association::Cells;
  /// One array per material; null for materials without fields and where a material lacks the field.
  /// A field that the materials share has the same array several times.
  std::vector<ValueArray> values;
};

/// What a simulation hands to Strata: a grid, materials, and where they are, and their fields.
///
/// The materials are given by volume fractions or by an id per cell. Volume fractions are checked: within
/// [0, 1], their sum is 1 up to rounding in every cell that is not hidden. A hidden cell is all `outside`,
/// which is then one of the materials.
struct Simulation
{
  Grid grid;
  Materials materials;
  /// One array per material, or none at all if `materialIds` says it.
  std::vector<ValueArray> fractions;
  Association fractionAssociation = Association::Cells;
  /// One id per cell, or empty. Ids are positions in `materials`.
  std::vector<std::int32_t> materialIds;
  std::vector<SimulationField> fields;
};
}
