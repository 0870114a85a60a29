#pragma once

#include "Extract/Extract.h"

#include <cstdint>

/// A number for everything that interfaces follow from: two inputs with the same number have the same interfaces, but
/// for a chance of 2^-64 or so. Cost: a pass over grid and fractions.
std::uint64_t fingerprintOf(const strata::Simulation& simulation, const strata::ExtractOptions& options);
