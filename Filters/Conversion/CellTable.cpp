#include "Conversion/CellTable.h"

#include <vtkCellType.h>

#include <initializer_list>
#include <numeric>

namespace strata::conversion
{
namespace
{
using Use = CellKind::Use;
using Table = std::array<CellKind, 256>;

void set(Table& table, std::initializer_list<int> types, Use use, CellShape shape, int cornerCount)
{
  for (const int type : types)
  {
    CellKind& kind = table[static_cast<std::size_t>(type)];
    kind.use = use;
    kind.shape = shape;
    kind.corners.resize(static_cast<std::size_t>(cornerCount));
    std::iota(kind.corners.begin(), kind.corners.end(), 0);
  }
}

/// A prism over a polygon: points 0..n-1 below, n..2n-1 above; faces point outwards.
void setPrism(Table& table, int type, int sides)
{
  set(table, { type }, Use::Prism, CellShape::Polyhedron, 2 * sides);
  auto& faces = table[static_cast<std::size_t>(type)].faces;
  faces.resize(2);
  for (int i = 0; i < sides; ++i)
  {
    const int next = (i + 1) % sides;
    faces[0].insert(faces[0].begin(), i);
    faces[1].push_back(sides + i);
    faces.push_back({ i, next, sides + next, sides + i });
  }
}

Table makeTable()
{
  Table table;
  set(table,
    { VTK_EMPTY_CELL, VTK_VERTEX, VTK_POLY_VERTEX, VTK_LINE, VTK_POLY_LINE, VTK_TRIANGLE, VTK_TRIANGLE_STRIP,
      VTK_POLYGON, VTK_PIXEL, VTK_QUAD, VTK_QUADRATIC_EDGE, VTK_QUADRATIC_TRIANGLE, VTK_QUADRATIC_QUAD,
      VTK_QUADRATIC_POLYGON, VTK_BIQUADRATIC_QUAD, VTK_QUADRATIC_LINEAR_QUAD, VTK_BIQUADRATIC_TRIANGLE, VTK_CUBIC_LINE,
      VTK_LAGRANGE_CURVE, VTK_LAGRANGE_TRIANGLE, VTK_LAGRANGE_QUADRILATERAL, VTK_BEZIER_CURVE, VTK_BEZIER_TRIANGLE,
      VTK_BEZIER_QUADRILATERAL },
    Use::Ignored, CellShape::Hexahedron, 0);
  set(table, { VTK_TETRA }, Use::Linear, CellShape::Tetrahedron, 4);
  set(table, { VTK_HEXAHEDRON, VTK_VOXEL }, Use::Linear, CellShape::Hexahedron, 8);
  table[VTK_VOXEL].corners = { 0, 1, 3, 2, 4, 5, 7, 6 };
  set(table, { VTK_WEDGE }, Use::Linear, CellShape::Wedge, 6);
  set(table, { VTK_PYRAMID }, Use::Linear, CellShape::Pyramid, 5);
  set(table, { VTK_QUADRATIC_TETRA, VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_TETRAHEDRON }, Use::Linearized,
    CellShape::Tetrahedron, 4);
  set(table,
    { VTK_QUADRATIC_HEXAHEDRON, VTK_TRIQUADRATIC_HEXAHEDRON, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON,
      VTK_LAGRANGE_HEXAHEDRON, VTK_BEZIER_HEXAHEDRON },
    Use::Linearized, CellShape::Hexahedron, 8);
  set(table,
    { VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_LINEAR_WEDGE, VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_LAGRANGE_WEDGE,
      VTK_BEZIER_WEDGE },
    Use::Linearized, CellShape::Wedge, 6);
  set(table, { VTK_QUADRATIC_PYRAMID, VTK_TRIQUADRATIC_PYRAMID, VTK_LAGRANGE_PYRAMID, VTK_BEZIER_PYRAMID },
    Use::Linearized, CellShape::Pyramid, 5);
  set(table, { VTK_POLYHEDRON }, Use::Polyhedron, CellShape::Polyhedron, 0);
  setPrism(table, VTK_PENTAGONAL_PRISM, 5);
  setPrism(table, VTK_HEXAGONAL_PRISM, 6);
  return table;
}
}

const CellKind& cellKind(int vtkType)
{
  static const Table table = makeTable();
  static const CellKind unknown;
  return vtkType >= 0 && vtkType < 256 ? table[static_cast<std::size_t>(vtkType)] : unknown;
}
}
