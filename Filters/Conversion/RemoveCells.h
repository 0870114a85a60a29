#pragma once

#include "Conversion/InputGrid.h"

#include <vector>

namespace strata::conversion
{
/// Takes cells (ascending) out of an unstructured grid, with their places in the input. Points stay.
void removeCells(InputGrid& input, const std::vector<Index>& cells);
}
