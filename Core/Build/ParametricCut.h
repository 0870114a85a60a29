#pragma once

#include "Build/Tetrahedron.h"

#include <vector>

namespace strata
{
/// The values of a function at the corners of a native cell; a tetrahedron uses the first four.
using CornerNumbers = std::array<double, 8>;

/// Where a cell and a native tetrahedron meet: the corners of their intersection, on which the length of a linear
/// function is largest.
class TetrahedronCut
{
public:
  TetrahedronCut(
    const std::array<Vector, 4>& corners, const Barycentric& barycentric, const std::array<Vector, 8>& native);

  /// The largest length of a function given by its components' values at the native corners: exact.
  double largestLength(const std::vector<CornerNumbers>& components) const;

private:
  std::vector<std::array<double, 4>> points_; ///< in the native tetrahedron's barycentric coordinates
};

/// Where a cell and a native hexahedron meet. In the hexahedron's three parameters, places, the cell's barycentric
/// coordinates and the difference native - represented are all multilinear, so no map has to be inverted.
class HexahedronCut
{
public:
  HexahedronCut(const Barycentric& barycentric, const std::array<Vector, 8>& native);

  struct Bounds
  {
    double upper;
    double reached; ///< at some point of both cells
  };
  /// Bounds of the largest length of a function given by its components' values at the native corners, found with at
  /// most so many bisections of the parameters: if they suffice, the upper one is no more than a fifth above the
  /// maximum or `known`, whichever is larger. For several components that holds for their bounds put together.
  Bounds largestLength(const std::vector<CornerNumbers>& components, double known, int bisections) const;

private:
  std::array<CornerNumbers, 4> weights_;
};
}
