#pragma once

#include "Geometry/Vector.h"
#include "Model/Materials.h"
#include "Model/NativeData.h"

#include <array>
#include <vector>

namespace strata
{
/// The native elements of one cell as rows of a linear system: what a value at a corner does to each error.
struct CellRows
{
  /// Weights of the four corners at a point.
  using Weights = std::array<double, 4>;

  /// Samples at which a field of a material is known.
  struct Samples
  {
    MaterialId material;
    std::size_t field = 0;
    int firstValue = 0; ///< position of the field's first component among a vertex's values of the material
    int components = 1;
    std::vector<Weights> weights;
    std::vector<double> values; ///< components interleaved
  };

  /// Vertices of the interface between two materials.
  struct InterfaceVertices
  {
    MaterialId positive;
    MaterialId negative;
    std::vector<Weights> weights;
  };

  std::array<Vector, 4> gradients; ///< of the corners' weights
  std::vector<Samples> samples;
  std::vector<InterfaceVertices> interfaces;
};
}
