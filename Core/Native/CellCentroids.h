#pragma once

#include "Model/Grid.h"
#include "Model/Progress.h"

#include <vector>

namespace strata
{
/// The centres of volume of all cells: where a cell's average value is its field's value up to second order,
/// exactly so for linear fields. A cell is the union of the tetrahedra from the mean of its corners to its
/// faces, each face fanned round the mean of its corners; exact for convex cells with plane faces. Cells
/// without volume get the mean of their corners.
std::vector<Vector> cellCentroids(const UnstructuredGrid& grid, Progress& progress);
}
