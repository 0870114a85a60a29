#pragma once

#include "Extract/CellVolumes.h"

namespace strata
{
/// Moves the values at the centres of cells, each of which belongs to its cell alone, so that the cell's volumes come
/// as close to their targets as that allows, without any change in the cells around. `changed` gets the vertices moved.
void settleCells(const CellComplex& complex, const CellVolumes& volumes, const std::vector<std::uint8_t>& winners,
  MaterialValues& values, std::vector<std::uint8_t>& changed, Progress& progress);
}
