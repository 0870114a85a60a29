#include "Pieces/PiecePoints.h"

#include <tbb/parallel_for.h>

namespace strata
{
PiecePoints::PiecePoints(const Representation& representation, const CellPieces& cells, MaterialSet materials)
{
  numberVertices(representation, cells, materials);
  cutUseOfCorner_.reserve(cells.corners.size());
  for (const PointUse& use : cells.corners)
  {
    const bool atVertex = use.point.carriers() == 1;
    cutUseOfCorner_.push_back(atVertex ? -1 : static_cast<Index>(cutUses_.size()));
    if (!atVertex)
    {
      cutUses_.push_back(use);
    }
  }
  shared_ = sharePoints(cutUses_);
}

void PiecePoints::numberVertices(const Representation& representation, const CellPieces& cells, MaterialSet materials)
{
  vertexNumbers_.resize(representation.materials.size());
  for (const MaterialId m : materials)
  {
    vertexNumbers_[m.value].assign(static_cast<std::size_t>(representation.vertexCount), -1);
  }
  for (const CellPiece& piece : cells.pieces)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      if (piece.corners < 0)
      {
        vertexNumbers_[piece.material][representation.tetrahedra[4 * piece.cell + corner]] = 0;
      }
      else if (cells.corners[piece.corners + corner].point.carriers() == 1)
      {
        vertexNumbers_[piece.material][cells.corners[piece.corners + corner].point.key.vertices[0]] = 0;
      }
    }
  }
  for (const MaterialId m : materials)
  {
    for (Index vertex = 0; vertex < representation.vertexCount; ++vertex)
    {
      if (vertexNumbers_[m.value][vertex] == 0)
      {
        vertexNumbers_[m.value][vertex] = static_cast<std::int32_t>(vertices_.size());
        vertices_.emplace_back(vertex, m.value);
      }
    }
  }
}

PointUse PiecePoints::use(Index point) const
{
  if (point >= vertexPoints())
  {
    return cutUses_[shared_.firstUse[point - vertexPoints()]];
  }
  PointUse result;
  result.point.key.vertices[0] = vertices_[point].first;
  result.owner = vertices_[point].second;
  return result;
}

Index PiecePoints::number(const CellPieces& cells, const Representation& representation, Index piece, int corner) const
{
  const CellPiece& at = cells.pieces[piece];
  if (at.corners < 0)
  {
    return vertexNumbers_[at.material][representation.tetrahedra[4 * at.cell + corner]];
  }
  const Index cutUse = cutUseOfCorner_[at.corners + corner];
  return cutUse < 0 ? vertexNumbers_[at.material][cells.corners[at.corners + corner].point.key.vertices[0]]
                    : vertexPoints() + shared_.numbers[cutUse];
}
}
