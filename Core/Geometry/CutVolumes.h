#pragma once

#include "Geometry/CutTetrahedron.h"

namespace strata
{
/// Volume of a tetrahedron as a fraction of the one in whose barycentric coordinates it is given; negative if turned
/// round.
double volumeFraction(const std::array<double, 4>& a, const std::array<double, 4>& b, const std::array<double, 4>& c,
  const std::array<double, 4>& d);

/// Volume of each region as a fraction of the tetrahedron, by position in the list of functions; sums to 1 up
/// to rounding. Faster than a cut for one or two functions; otherwise `workspace` is used for it.
void regionVolumes(const CornerValues* functions, int count, TetrahedronCut& workspace, double* volumes);

/// Volume of the part of a tetrahedron where a linear function is not positive, as a fraction, and how it grows when a
/// constant is subtracted from the function.
struct NegativePart
{
  double volume = 0.0;
  double derivative = 0.0;
};
/// From the function's values at the corners.
NegativePart negativePart(std::array<double, 4> values);

/// As regionVolumes; also how the volumes change when constants are added to the functions:
/// derivatives[count * i + j] = d volumes[i] / d constant[j]. Symmetric, each row sums to 0, and positive off the
/// diagonal: the interface's area over the length of the gradient of the difference.
void regionVolumesAndDerivatives(
  const CornerValues* functions, int count, TetrahedronCut& workspace, double* volumes, double* derivatives);

/// As regionVolumesAndDerivatives, but the constants are added to the functions' values at the first corner alone.
void regionVolumesAndCornerDerivatives(
  const CornerValues* functions, int count, TetrahedronCut& workspace, double* volumes, double* derivatives);
}
