#pragma once

#include "Measure/Measure.h"

class vtkFieldData;
class vtkTable;

namespace strata::conversion
{
/// A row for each material and field, each interface and each material (design 4). Columns that say nothing about a
/// row hold NaN. `claims` are the representation's field data with its achieved errors.
void writeErrors(
  const RepresentationErrors& errors, const Representation& representation, vtkFieldData* claims, vtkTable* output);
}
