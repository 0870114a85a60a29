#pragma once

#include "Geometry/Vector.h"
#include "Model/Materials.h"

#include <array>
#include <cstdint>

namespace strata
{
/// Position of a native sample in its data set.
using SampleIndex = std::uint32_t;

/// Position of a native cell in its data set.
using NativeCellIndex = std::uint32_t;

/// A cell between native samples over which fields are functions of the place, for the materials that all of its
/// corners count for.
struct NativeCell
{
  /// How the samples at the corners make a function.
  enum class Kind : std::uint8_t
  {
    Box,         ///< multilinear on an axis-aligned box; corner i lies at the upper end of axis a if bit a of i is set
    Tetrahedron, ///< linear; the first four corners
    Hexahedron   ///< place and value are multilinear functions of the same three parameters; corners as in a box
  };

  Kind kind = Kind::Box;
  std::array<SampleIndex, 8> samples{};
  std::array<Vector, 8> corners;
  MaterialSet materials;

  int cornerCount() const { return kind == Kind::Tetrahedron ? 4 : 8; }
};
}
