#pragma once

#include "Model/MaterialPolygons.h"

class vtkPolyData;

namespace strata::conversion
{
/// Hands the polygons of a slice or a contour over: cell arrays `material` and `tetrahedron`, point arrays `<field>`,
/// and the names of the materials as field data.
void writePolygons(MaterialPolygons&& polygons, const Representation& representation, vtkPolyData* output);
}
