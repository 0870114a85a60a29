#pragma once

#include "Model/Grid.h"

#include <utility>
#include <vector>

namespace strata::conversion
{
/// The cells with the same corners, in any order, as an earlier one: (cell, the first such), by cell.
std::vector<std::pair<Index, Index>> repeatedCells(const UnstructuredGrid& grid);
}
