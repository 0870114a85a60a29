#pragma once

#include "Extract/GridTopology.h"
#include "Model/Progress.h"

#include <array>
#include <vector>

namespace strata
{
/// Some cells of a grid, cut into tetrahedra that nest in them and match across their faces.
///
/// Vertices: grid points, face centres, cell centres, in this order. Every face with n corners is a fan of n
/// triangles about its centre, and each of those spans a tetrahedron with the centre of the cell.
struct CellComplex
{
  static constexpr std::int32_t none = -1;

  std::vector<Index> cells; ///< native ids, ascending
  std::vector<Index> nodes; ///< native point ids, ascending

  /// Corners (vertices) of face f: faceCorners[faceStart[f]] .. faceCorners[faceStart[f + 1]], in cyclic order.
  std::vector<std::int32_t> faceStart;
  std::vector<std::int32_t> faceCorners;
  /// The native cells on the two sides of a face, the lower first; -1 second on the grid's boundary.
  std::vector<std::array<Index, 2>> faceCells;

  /// Faces of cell c: cellFaces[cellFaceStart[c]] .. cellFaces[cellFaceStart[c + 1]].
  std::vector<std::int32_t> cellFaceStart;
  struct OrientedFace
  {
    std::int32_t face;
    bool reversed; ///< the face's corners run clockwise as seen from outside the cell
  };
  std::vector<OrientedFace> cellFaces;

  std::vector<Vector> positions; ///< by vertex

  std::int32_t nodeCount() const { return static_cast<std::int32_t>(nodes.size()); }
  std::int32_t faceCount() const { return static_cast<std::int32_t>(faceCells.size()); }
  std::int32_t cellCount() const { return static_cast<std::int32_t>(cells.size()); }
  std::int32_t vertexCount() const { return nodeCount() + faceCount() + cellCount(); }
  std::int32_t faceVertex(std::int32_t face) const { return nodeCount() + face; }
  std::int32_t cellVertex(std::int32_t cell) const { return nodeCount() + faceCount() + cell; }

  /// Calls visit(cellCentre, faceCentre, a, b) for the tetrahedra of a cell, positively oriented.
  template<typename Visit>
  void forEachTetrahedron(std::int32_t cell, const Visit& visit) const
  {
    for (std::int32_t i = cellFaceStart[cell]; i < cellFaceStart[cell + 1]; ++i)
    {
      forEachTriangle(cellFaces[i],
        [&](std::int32_t center, std::int32_t a, std::int32_t b) { visit(cellVertex(cell), center, a, b); });
    }
  }

  /// Calls visit(faceCentre, a, b) for a face's triangles, counter-clockwise as seen from outside the cell.
  template<typename Visit>
  void forEachTriangle(OrientedFace oriented, const Visit& visit) const
  {
    const std::int32_t first = faceStart[oriented.face];
    const std::int32_t count = faceStart[oriented.face + 1] - first;
    for (std::int32_t k = 0; k < count; ++k)
    {
      const std::int32_t a = faceCorners[first + k];
      const std::int32_t b = faceCorners[first + (k + 1) % count];
      visit(faceVertex(oriented.face), oriented.reversed ? b : a, oriented.reversed ? a : b);
    }
  }
};

/// Cuts the given cells (ascending, none of them hidden).
CellComplex makeCellComplex(const GridTopology& topology, std::vector<Index> cells, Progress& progress);
}
