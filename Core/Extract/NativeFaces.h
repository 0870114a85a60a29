#pragma once

#include "Extract/GridTopology.h"

namespace strata
{
/// Appends the faces of a cell as the grid lists them; all neighbours are -1.
void addNativeFaces(const UnstructuredGrid& grid, Index cell, CellFaces& faces);

/// Whether a cell, as the grid lists it, has a face with exactly these `count` corners (all different, any order).
bool hasNativeFace(const UnstructuredGrid& grid, Index cell, const Index* corners, std::size_t count);
}
