#pragma once

#include "Model/Grid.h"

#include <array>
#include <vector>

namespace strata::conversion
{
/// What becomes of a VTK cell type.
struct CellKind
{
  enum class Use : std::uint8_t
  {
    Unknown,
    Ignored, ///< no volume: a vertex, line or surface cell
    Linear,
    Linearized, ///< its corner points stand for a curved cell
    Polyhedron, ///< with its own list of faces
    Prism       ///< a polyhedron with the faces given here
  };
  Use use = Use::Unknown;
  CellShape shape = CellShape::Hexahedron;
  /// Which of the VTK cell's points are the corners, in the core's order.
  std::vector<int> corners;
  /// Faces of a prism, as positions in `corners`.
  std::vector<std::vector<int>> faces;
};

/// The kind of a VTK cell type.
const CellKind& cellKind(int vtkType);
}
