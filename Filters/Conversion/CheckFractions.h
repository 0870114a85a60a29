#pragma once

#include "Conversion/InputGrid.h"

#include "Model/Simulation.h"

namespace strata::conversion
{
/// Fractions may leave [0, 1], and their sum 1, by this much without a word: solvers overshoot.
constexpr double silentDeviation = 0.01;
/// From here on they can't be used; in between there is a warning.
constexpr double largestDeviation = 0.1;

/// Where a simulation's fractions stand, and how to name the places.
struct FractionPlaces
{
  const InputGrid& input;
  Association association;
  const std::vector<std::uint8_t>& hidden; ///< per cell, or empty
};

/// True if some visible cell (point) holds nothing at all of the materials.
bool leaveSpace(const std::vector<ValueArray>& fractions, const FractionPlaces& places);

/// The fraction that the materials leave in each cell (point), at least 0.
ValueArray remainderOf(const std::vector<ValueArray>& fractions);

/// Clamps fractions to [0, 1] and scales them to sum 1 where they deviate a little. Warns from `silentDeviation`
/// on, with the number of places and the worst; throws InvalidInput from `largestDeviation` on and for values
/// that are not finite.
void normaliseFractions(std::vector<ValueArray>& fractions, const std::vector<std::string>& names,
  const FractionPlaces& places, Warnings& warnings);
}
