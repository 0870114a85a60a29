#pragma once

#include "Pieces/CellPieces.h"

#include <vector>

namespace strata
{
/// The points of pieces, shared within a material: first the mesh's vertices by material and vertex, then the points
/// of cuts in the order of their first use.
class PiecePoints
{
public:
  PiecePoints(const Representation& representation, const CellPieces& cells, MaterialSet materials);

  Index count() const { return vertexPoints() + static_cast<Index>(shared_.firstUse.size()); }
  /// The point and its material.
  PointUse use(Index point) const;
  /// The number of a corner of a piece.
  Index number(const CellPieces& cells, const Representation& representation, Index piece, int corner) const;

private:
  Index vertexPoints() const { return static_cast<Index>(vertices_.size()); }
  void numberVertices(const Representation& representation, const CellPieces& cells, MaterialSet materials);

  /// [material][vertex]: number of the point, -1 if there is none; empty for materials that aren't asked for.
  std::vector<std::vector<std::int32_t>> vertexNumbers_;
  /// Vertex and material of the first points.
  std::vector<std::pair<std::int64_t, std::int32_t>> vertices_;
  /// Uses of points that are no vertices, and for each corner of cut pieces its place among them, or -1.
  std::vector<PointUse> cutUses_;
  std::vector<Index> cutUseOfCorner_;
  SharedPoints shared_;
};
}
