#pragma once

#include "Sample/Sample.h"

#include <vector>

class vtkDataSet;

namespace strata::conversion
{
/// The points of any data set, 3 coordinates each.
std::vector<double> coordinatesOf(vtkDataSet* data);

/// Adds a representation's answers as point arrays: `material`, each `<field>`, `outside`.
void writeSamples(Samples&& samples, const Representation& representation, vtkDataSet* output);
}
