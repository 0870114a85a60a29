#pragma once

#include <string>

class vtkAlgorithm;
class vtkDataObject;
class vtkStringArray;

namespace strata::conversion
{
/// The number of a pair of different materials among the pairs of `count` materials, whichever comes first.
inline int pairNumber(int a, int b, int count)
{
  const int low = a < b ? a : b;
  const int high = a < b ? b : a;
  return low * count - low * (low + 1) / 2 + high - low - 1;
}

/// What the categories of an output are called, a line "<number><tab><name>" for each: the pairs where it has a cell
/// array `pair` (all pairs if they are few, else those that occur), else the materials, with "several" for -1 where
/// that occurs. Materials without fields have a further "<tab>plain". Empty for an output without material names.
std::string legendOf(vtkDataObject* output);

/// The names of an output's materials, "a, b, c"; "" if it has none.
std::string materialNamesOf(vtkDataObject* output);

/// Lists the materials that a filter's first input is likely to have, for the user to choose from: those that it names
/// itself (cases, representations), else those whose arrays of volume fractions are recognized. Looks at no value.
void listInputMaterials(vtkAlgorithm* filter, vtkStringArray* names);
}
