#include "Model/ShapeFaces.h"

namespace strata
{
namespace
{
constexpr int tetrahedronFaces[4][4] = { { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 2, 0, 3, -1 }, { 0, 2, 1, -1 } };
constexpr int hexahedronFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 },
  { 4, 5, 6, 7 } };
constexpr int wedgeFaces[5][4] = { { 0, 1, 2, -1 }, { 3, 5, 4, -1 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } };
constexpr int pyramidFaces[5][4] = { { 0, 3, 2, 1 }, { 0, 1, 4, -1 }, { 1, 2, 4, -1 }, { 2, 3, 4, -1 },
  { 3, 0, 4, -1 } };
}

ShapeFaces facesOf(CellShape shape)
{
  switch (shape)
  {
    case CellShape::Tetrahedron:
      return { tetrahedronFaces, 4 };
    case CellShape::Hexahedron:
      return { hexahedronFaces, 6 };
    case CellShape::Wedge:
      return { wedgeFaces, 5 };
    case CellShape::Pyramid:
      return { pyramidFaces, 5 };
    case CellShape::Polyhedron:
      break;
  }
  return { nullptr, 0 };
}
}
