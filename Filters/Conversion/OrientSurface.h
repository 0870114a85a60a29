#pragma once

#include "Geometry/Vector.h"
#include "Model/Ids.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace strata::conversion
{
/// The points of a triangle, by their positions in the surface.
using SurfaceTriangle = std::array<Index, 3>;

/// Turns the pieces of a surface whose winding disagrees with its own normals; without normals nothing turns. A
/// piece, triangles that share edges and agree on their winding, turns as a whole: at the tip of a spike
/// the mean normals of its points may well point against a single triangle's.
void orient(vtkPolyData* surface, const std::vector<Vector>& points, std::vector<SurfaceTriangle>& triangles);
}
