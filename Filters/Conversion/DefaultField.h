#pragma once

#include <string>

namespace strata::conversion
{
/// What is known of a field that may be taken where nobody says which.
struct FieldCandidate
{
  std::string name;
  bool ownArrays = false;      ///< some material has values of its own
  bool mixedMaterials = false; ///< materials are given by volume fractions, so cells may hold several
};

/// How early a field comes among those that may be taken where nobody says which: 0 first. By its name alone, so that
/// the choice stays the same over time: density, pressure, temperature, energy, velocity, others, masses and the
/// like. A density that materials share in mixed cells is that of no material; it comes after energy.
int defaultOrder(const FieldCandidate& field);

/// The order of masses, numbers and other values that make no picture.
constexpr int lastDefaultOrder = 7;
}
