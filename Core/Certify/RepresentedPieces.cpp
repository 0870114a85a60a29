#include "Certify/RepresentedPieces.h"

#include "Model/CellDistances.h"

namespace strata
{
std::vector<InterfacePiece> representedPieces(const Representation& representation, Index cell, TetrahedronCut& cut)
{
  std::vector<InterfacePiece> pieces;
  std::vector<CornerValues> distances;
  distancesOfCell(representation, cell, distances);
  if (distances.size() < 2)
  {
    return pieces;
  }
  cut.cut(verticesOfCell(representation, cell), distances.data(), static_cast<int>(distances.size()));
  for (const TetrahedronCut::Face& face : cut.faces())
  {
    if (!face.isInterface())
    {
      continue;
    }
    pieces.push_back({ UnorderedPair::of(MaterialId(face.function), MaterialId(face.beyond)), {} });
    for (int i = face.begin; i < face.end; ++i)
    {
      const CutPoint& point = cut.points()[static_cast<std::size_t>(cut.loops()[static_cast<std::size_t>(i)])];
      pieces.back().corners.push_back(
        point.interpolate([&](std::int64_t vertex) -> Vector { return representation.point(vertex); }));
    }
  }
  return pieces;
}
}
