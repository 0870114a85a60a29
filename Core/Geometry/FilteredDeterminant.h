#pragma once

#include "Geometry/ExactDeterminant.h"

namespace strata
{
/// The exact sign of the determinant of a matrix whose last column holds 0 and 1, with a 1 below the first row.
/// Evaluated in floating point where rounding can't change the sign, else exactly.
int signOfDeterminant(const SmallMatrix& matrix);

/// The determinant of such a matrix to about ten digits, and 0 only if it is.
double accurateDeterminant(const SmallMatrix& matrix);
}
