#pragma once

#include "Model/MaterialPolygons.h"
#include "Model/Progress.h"

namespace strata
{
/// Where a scalar field of each of the given materials takes one of some values: polygons that end sharply at the
/// material's border, by the exact kernel of the slices. Counter-clockwise seen from the side of larger values. A
/// vertex that has a value counts as larger. Polygons of different values share no points. Materials without the field
/// give nothing. Throws InvalidInput for an unknown field, a field of several components and a value that is not
/// finite.
MaterialPolygons contour(const Representation& representation, FieldId field, const std::vector<double>& values,
  MaterialSet materials, Progress& progress);
}
