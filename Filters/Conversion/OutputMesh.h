#pragma once

#include "Conversion/ReadSimulation.h"

#include "Model/Mesh.h"

#include <vector>

class vtkUnstructuredGrid;

namespace strata::conversion
{
/// Hands a mesh over to a grid with the arrays and the field data of a representation (design 1), without a copy.
/// Buffers that are empty make no array.
void writeMesh(Mesh&& mesh, vtkUnstructuredGrid* output);

/// Says in the field data what the achieved errors leave out, as numbers to add to them: `not_in_interface_error`, and
/// `not_in_field_error_<field>` per field. Nothing where the data have no curved cells.
void writeDeviations(const Deviations& deviations, const std::vector<Field>& fields, vtkUnstructuredGrid* output);
}
