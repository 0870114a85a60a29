#pragma once

#include <optional>
#include <string>

namespace strata::conversion
{
/// The material whose volume fractions an array of this name holds by the conventions of the simulation codes
/// (`volume_fraction_block`, `block_vf`, `vf_block`, `alpha.block`, `Volume Fraction for Armor Plate`,
/// `Armor Plate Volume Fraction`, `liquid_fraction`, `Material volume fraction - 3` -> `Material 3`);
/// nothing for other names. Upper and lower case of the convention's words don't matter.
std::optional<std::string> materialOfFractions(const std::string& arrayName);

/// Materials of these names are taken to be empty space: empty, void, vacuum, outside.
bool isEmptySpace(const std::string& materialName);

/// True for the usual names of arrays with material ids: material, material_id, MaterialIds, ...
bool isMaterialIdName(const std::string& arrayName);
}
