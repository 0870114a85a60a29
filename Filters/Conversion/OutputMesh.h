#pragma once

#include "Model/Mesh.h"

class vtkUnstructuredGrid;

namespace strata::conversion
{
/// Hands a mesh over to a grid with the arrays and the field data of a representation (design 1), without a copy.
/// Buffers that are empty make no array.
void writeMesh(Mesh&& mesh, vtkUnstructuredGrid* output);
}
