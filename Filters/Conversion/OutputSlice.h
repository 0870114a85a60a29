#pragma once

#include "Slice/Slice.h"

class vtkPolyData;

namespace strata::conversion
{
/// Hands the polygons of a slice over: cell arrays `material` and `tetrahedron`, point arrays `<field>`, and the
/// names of the materials as field data.
void writeSlice(SlicePolygons&& polygons, const Representation& representation, vtkPolyData* output);
}
