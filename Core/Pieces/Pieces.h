#pragma once

#include "Model/Progress.h"
#include "Model/Representation.h"

namespace strata
{
/// The solid pieces of materials as tetrahedra (design 3.8 c). Points are shared within a material only.
struct Pieces
{
  Buffer<double> points;
  Buffer<std::int64_t> tetrahedra;      ///< 4 per piece, positively oriented
  Buffer<std::int32_t> material;        ///< one per piece
  Buffer<std::int64_t> cell;            ///< one per piece: the representation's cell
  std::vector<Buffer<float>> values;    ///< [field], of the piece's material
  std::vector<Buffer<float>> distances; ///< [material], interpolated
};

/// Cuts the regions of the given materials out of a representation, without gap or overlap.
Pieces cutPieces(const Representation& representation, MaterialSet materials, Progress& progress);

/// The represented interfaces as triangles, with the fields of both sides (design 3.8 b).
struct RepresentedSurfaces
{
  Buffer<double> points;          ///< shared between all surfaces
  Buffer<std::int64_t> triangles; ///< 3 per triangle; the normal points into the positive material
  Buffer<std::int32_t> positive;  ///< one per triangle
  Buffer<std::int32_t> negative;  ///< one per triangle; positive < negative
  Buffer<std::int64_t> cell;      ///< one per triangle: the representation's cell
  /// [field]: one tuple per triangle corner (3 per triangle), NaN for a side without fields.
  std::vector<Buffer<float>> positiveValues;
  std::vector<Buffer<float>> negativeValues;
};

RepresentedSurfaces representedInterfaces(const Representation& representation, Progress& progress);
}
