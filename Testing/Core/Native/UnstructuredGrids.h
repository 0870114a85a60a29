#pragma once

#include "Model/Grid.h"

#include <array>
#include <vector>

namespace strata::test
{
/// Adds a cell by its corners.
inline void addCell(UnstructuredGrid& grid, CellShape shape, const std::vector<Index>& corners)
{
  if (grid.cornerOffsets.empty())
  {
    grid.cornerOffsets.push_back(0);
  }
  grid.shapes.push_back(shape);
  grid.corners.insert(grid.corners.end(), corners.begin(), corners.end());
  grid.cornerOffsets.push_back(static_cast<Index>(grid.corners.size()));
}

/// Adds a hexahedron's six faces as those of a polyhedron.
inline void addBoxFaces(UnstructuredGrid& grid, const std::vector<Index>& c)
{
  if (grid.faceOffsets.empty())
  {
    grid.faceOffsets.push_back(0);
    grid.faceStart.push_back(0);
  }
  const std::array<std::array<std::size_t, 4>, 6> faces = { { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
    { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } } };
  for (const auto& face : faces)
  {
    for (const std::size_t i : face)
    {
      grid.faceCorners.push_back(c[i]);
    }
    grid.faceStart.push_back(static_cast<Index>(grid.faceCorners.size()));
  }
  grid.faceOffsets.push_back(static_cast<Index>(grid.faceStart.size()) - 1);
}

/// Adds a hexahedron as cells of a shape: itself, two wedges, six tetrahedra, or six pyramids to a new centre point.
inline void addBox(UnstructuredGrid& grid, CellShape shape, const std::vector<Index>& c)
{
  const auto at = [&](std::initializer_list<std::size_t> picks) {
    std::vector<Index> result;
    for (const std::size_t i : picks)
    {
      result.push_back(c[i]);
    }
    return result;
  };
  switch (shape)
  {
    case CellShape::Hexahedron:
      addCell(grid, shape, c);
      break;
    case CellShape::Polyhedron:
      addCell(grid, shape, c);
      addBoxFaces(grid, c);
      break;
    case CellShape::Wedge:
      addCell(grid, shape, at({ 0, 1, 2, 4, 5, 6 }));
      addCell(grid, shape, at({ 0, 2, 3, 4, 6, 7 }));
      break;
    case CellShape::Tetrahedron:
      for (const auto& t : { at({ 0, 1, 2, 6 }), at({ 0, 2, 3, 6 }), at({ 0, 3, 7, 6 }), at({ 0, 7, 4, 6 }),
             at({ 0, 4, 5, 6 }), at({ 0, 5, 1, 6 }) })
      {
        addCell(grid, shape, t);
      }
      break;
    case CellShape::Pyramid: {
      Vector center = Vector::Zero();
      for (const Index corner : c)
      {
        center += grid.points[static_cast<std::size_t>(corner)] / 8.0;
      }
      const Index apex = grid.pointCount();
      grid.points.push_back(center);
      for (auto face : { at({ 0, 3, 2, 1 }), at({ 4, 5, 6, 7 }), at({ 0, 1, 5, 4 }), at({ 1, 2, 6, 5 }),
             at({ 2, 3, 7, 6 }), at({ 3, 0, 4, 7 }) })
      {
        face.push_back(apex);
        addCell(grid, shape, face);
      }
      break;
    }
  }
}

/// A rectilinear grid as cells of a given shape.
inline UnstructuredGrid unstructured(const RectilinearGrid& grid, CellShape shape)
{
  UnstructuredGrid result;
  const Index nx = grid.pointCount(0);
  const Index ny = grid.pointCount(1);
  for (Index p = 0; p < grid.pointCount(); ++p)
  {
    result.points.emplace_back(grid.coordinates[0][static_cast<std::size_t>(p % nx)],
      grid.coordinates[1][static_cast<std::size_t>((p / nx) % ny)],
      grid.coordinates[2][static_cast<std::size_t>(p / (nx * ny))]);
  }
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const Index i = cell % (nx - 1);
    const Index j = (cell / (nx - 1)) % (ny - 1);
    const Index k = cell / ((nx - 1) * (ny - 1));
    const Index p = i + nx * (j + ny * k);
    const Index above = p + nx * ny;
    addBox(result, shape, { p, p + 1, p + nx + 1, p + nx, above, above + 1, above + nx + 1, above + nx });
  }
  return result;
}
}
