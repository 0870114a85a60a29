#pragma once

#include "Pieces/Pieces.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace strata::conversion
{
/// Hands solid pieces over: cell arrays `material` and `cell`, point arrays `<field>` and `distance_<m>`.
void writePieces(Pieces&& pieces, const Representation& representation, vtkUnstructuredGrid* output);

/// Hands represented interfaces over: cell arrays `pair`, `positive_material`, `negative_material`,
/// `cell`; point arrays
/// `<field>_positive`, `<field>_negative`, `<field>_jump` (positive minus negative). Points are not shared between
/// triangles, as the fields of the two sides differ from triangle to triangle where three materials meet.
void writeRepresentedSurfaces(
  RepresentedSurfaces&& surfaces, const Representation& representation, vtkPolyData* output);
}
