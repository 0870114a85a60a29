#include "Conversion/OrientSurface.h"

#include "Conversion/ValueConversion.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <tuple>

namespace strata::conversion
{
namespace
{
/// An edge as a triangle walks along it.
struct DirectedEdge
{
  Index from;
  Index to;
  std::size_t triangle;

  bool operator<(const DirectedEdge& other) const
  {
    return std::tie(from, to, triangle) < std::tie(other.from, other.to, other.triangle);
  }
};

/// Finds the triangles across the edges of others, where both agree on their winding.
class Neighbours
{
public:
  explicit Neighbours(const std::vector<SurfaceTriangle>& triangles)
  {
    edges_.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        edges_.push_back({ triangles[t][k], triangles[t][(k + 1) % 3], t });
      }
    }
    std::sort(edges_.begin(), edges_.end());
  }

  /// Calls visit(triangle) for each triangle that walks from `from` to `to`.
  template<typename Visit>
  void along(Index from, Index to, const Visit& visit) const
  {
    for (auto edge = std::lower_bound(edges_.begin(), edges_.end(), DirectedEdge{ from, to, 0 });
         edge != edges_.end() && edge->from == from && edge->to == to; ++edge)
    {
      visit(edge->triangle);
    }
  }

private:
  std::vector<DirectedEdge> edges_;
};

/// The piece of each triangle, named by its first triangle.
std::vector<std::size_t> piecesOf(const std::vector<SurfaceTriangle>& triangles)
{
  constexpr auto none = static_cast<std::size_t>(-1);
  const Neighbours neighbours(triangles);
  std::vector<std::size_t> piece(triangles.size(), none);
  std::vector<std::size_t> stack;
  for (std::size_t first = 0; first < triangles.size(); ++first)
  {
    stack.push_back(first);
    while (!stack.empty())
    {
      const std::size_t t = stack.back();
      stack.pop_back();
      if (piece[t] != none)
      {
        continue;
      }
      piece[t] = first;
      for (std::size_t k = 0; k < 3; ++k)
      {
        neighbours.along(
          triangles[t][(k + 1) % 3], triangles[t][k], [&](std::size_t other) { stack.push_back(other); });
      }
    }
  }
  return piece;
}
}

void orient(vtkPolyData* surface, const std::vector<Vector>& points, std::vector<SurfaceTriangle>& triangles)
{
  vtkDataArray* atPoints = surface->GetPointData()->GetNormals();
  vtkDataArray* inCells = surface->GetCellData()->GetNormals();
  if ((!atPoints && !inCells) || triangles.empty())
  {
    return;
  }
  const ValueArray normals = valuesOf(atPoints ? atPoints : inCells);
  const auto normal = [&](Index i) { return Vector(normals(i, 0), normals(i, 1), normals(i, 2)); };
  const std::vector<std::size_t> piece = piecesOf(triangles);
  std::vector<double> agreement(triangles.size(), 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const SurfaceTriangle& triangle = triangles[t];
    const Vector& p = points[static_cast<std::size_t>(triangle[0])];
    const Vector area =
      (points[static_cast<std::size_t>(triangle[1])] - p).cross(points[static_cast<std::size_t>(triangle[2])] - p);
    const Vector given = atPoints ? Vector(normal(triangle[0]) + normal(triangle[1]) + normal(triangle[2]))
                                  : normal(static_cast<Index>(t));
    agreement[piece[t]] += area.dot(given);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (agreement[piece[t]] < 0.0)
    {
      std::swap(triangles[t][1], triangles[t][2]);
    }
  }
}
}
