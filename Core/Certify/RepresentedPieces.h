#pragma once

#include "Geometry/CutTetrahedron.h"
#include "Model/InterfacePiece.h"
#include "Model/Representation.h"

namespace strata
{
/// The polygons between the materials of a cell, as everything that reads the mesh will find them. `cut` is a
/// workspace. Throws InvalidInput for a cell without materials.
std::vector<InterfacePiece> representedPieces(const Representation& representation, Index cell, TetrahedronCut& cut);
}
