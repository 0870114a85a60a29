#pragma once

#include "Geometry/Vector.h"

#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderWedge.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <vector>

struct CurvedType
{
  const char* name;
  int type;
  int nodes;
  int pieces;
  int boundaryFaces; ///< of the pieces, on the cell's faces
};

// A triangle is cut into n^2 triangles, a quadrilateral into n^2 quadrilaterals (n m on a wedge of degrees n and m).
inline const CurvedType curvedTypes[] = { { "quadratic tetrahedron", VTK_QUADRATIC_TETRA, 10, 8, 16 },
  { "quadratic hexahedron", VTK_QUADRATIC_HEXAHEDRON, 20, 8, 24 },
  { "triquadratic hexahedron", VTK_TRIQUADRATIC_HEXAHEDRON, 27, 8, 24 },
  { "biquadratic hexahedron", VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, 8, 24 },
  { "quadratic wedge", VTK_QUADRATIC_WEDGE, 15, 8, 20 },
  { "quadratic linear wedge", VTK_QUADRATIC_LINEAR_WEDGE, 12, 4, 14 },
  { "biquadratic wedge", VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, 8, 20 },
  { "quadratic pyramid", VTK_QUADRATIC_PYRAMID, 13, 10, 20 },
  { "triquadratic pyramid", VTK_TRIQUADRATIC_PYRAMID, 19, 10, 20 },
  { "Lagrange tetrahedron", VTK_LAGRANGE_TETRAHEDRON, 20, 27, 36 },
  { "Lagrange hexahedron", VTK_LAGRANGE_HEXAHEDRON, 64, 27, 54 }, { "Lagrange wedge", VTK_LAGRANGE_WEDGE, 40, 27, 45 },
  { "Bezier tetrahedron", VTK_BEZIER_TETRAHEDRON, 20, 27, 36 },
  { "Bezier hexahedron", VTK_BEZIER_HEXAHEDRON, 27, 8, 24 }, { "Bezier wedge", VTK_BEZIER_WEDGE, 18, 8, 20 } };

using Map = std::function<strata::Vector(const strata::Vector&)>;

inline strata::Vector bent(const strata::Vector& p)
{
  return { p[0] + 0.1 * p[1] * p[1], p[1] + 0.1 * p[2] * p[0], p[2] + 0.1 * p[0] * p[1] };
}

/// One cell whose nodes lie where a map takes those of the unit cell.
inline vtkSmartPointer<vtkUnstructuredGrid> oneCell(const CurvedType& kind, const Map& map)
{
  vtkNew<vtkGenericCell> generic;
  generic->SetCellType(kind.type);
  vtkCell* cell = generic->GetRepresentativeCell();
  cell->GetPointIds()->SetNumberOfIds(kind.nodes);
  cell->GetPoints()->SetNumberOfPoints(kind.nodes);
  if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    hexahedron->SetUniformOrderFromNumPoints(kind.nodes);
  }
  if (auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell))
  {
    wedge->SetUniformOrderFromNumPoints(kind.nodes);
  }
  cell->Initialize();
  const double* parameters = cell->GetParametricCoords();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids;
  for (int node = 0; node < kind.nodes; ++node)
  {
    const double* p = parameters + 3 * node;
    // The sections of this pyramid all have parameters from 0 to 1.
    const double width = kind.type == VTK_QUADRATIC_PYRAMID ? 1.0 - p[2] : 1.0;
    const strata::Vector place = map(strata::Vector(width * p[0], width * p[1], p[2]));
    ids.push_back(points->InsertNextPoint(place.data()));
  }
  grid->SetPoints(points);
  grid->InsertNextCell(kind.type, kind.nodes, ids.data());
  return grid;
}
