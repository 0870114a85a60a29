#pragma once

#include "Extract/GridTopology.h"
#include "Geometry/Box.h"
#include "Support/FractionsOnGrids.h"

#include <Eigen/Geometry>

namespace strata::test
{
namespace detail
{
/// Replaces each hexahedron by cells over its corners; `parts` lists them by VTK's corner numbers. Corner 8 stands
/// for the cell's centre.
inline UnstructuredGrid replaceCells(
  const RectilinearGrid& grid, CellShape shape, const std::vector<std::vector<int>>& parts, bool withCenter)
{
  const UnstructuredGrid hexahedra = asHexahedra(grid);
  UnstructuredGrid result;
  result.points = hexahedra.points;
  result.cornerOffsets = { 0 };
  for (Index cell = 0; cell < hexahedra.cellCount(); ++cell)
  {
    if (withCenter)
    {
      result.points.push_back(cellBox(grid, cell).center());
    }
    for (const std::vector<int>& part : parts)
    {
      for (int corner : part)
      {
        result.corners.push_back(
          corner == 8 ? result.pointCount() - 1 : hexahedra.corners[hexahedra.cornerOffsets[cell] + corner]);
      }
      result.shapes.push_back(shape);
      result.cornerOffsets.push_back(static_cast<Index>(result.corners.size()));
    }
  }
  return result;
}
}

/// Kuhn's six tetrahedra per cube.
inline UnstructuredGrid tetrahedra(int n)
{
  return detail::replaceCells(cubeGrid(n), CellShape::Tetrahedron,
    { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 }, { 0, 4, 5, 6 }, { 0, 5, 1, 6 } }, false);
}

inline UnstructuredGrid wedges(int n)
{
  return detail::replaceCells(cubeGrid(n), CellShape::Wedge, { { 0, 1, 2, 4, 5, 6 }, { 0, 2, 3, 4, 6, 7 } }, false);
}

/// A pyramid from each face of a cube to its centre.
inline UnstructuredGrid pyramids(int n)
{
  return detail::replaceCells(cubeGrid(n), CellShape::Pyramid,
    { { 0, 1, 2, 3, 8 }, { 7, 6, 5, 4, 8 }, { 0, 4, 5, 1, 8 }, { 1, 5, 6, 2, 8 }, { 2, 6, 7, 3, 8 },
      { 3, 7, 4, 0, 8 } },
    true);
}

/// The cubes as polyhedra, the faces listed with alternating orientation.
inline UnstructuredGrid polyhedra(int n)
{
  UnstructuredGrid result = asHexahedra(cubeGrid(n));
  const int faces[6][4] = { { 0, 3, 2, 1 }, { 4, 7, 6, 5 }, { 0, 1, 5, 4 }, { 1, 5, 6, 2 }, { 2, 3, 7, 6 },
    { 3, 7, 4, 0 } };
  result.faceOffsets = { 0 };
  result.faceStart = { 0 };
  for (Index cell = 0; cell < result.cellCount(); ++cell)
  {
    result.shapes[cell] = CellShape::Polyhedron;
    for (const auto& face : faces)
    {
      for (int corner : face)
      {
        result.faceCorners.push_back(result.corners[result.cornerOffsets[cell] + corner]);
      }
      result.faceStart.push_back(static_cast<Index>(result.faceCorners.size()));
    }
    result.faceOffsets.push_back(static_cast<Index>(result.faceStart.size()) - 1);
  }
  return result;
}

/// The part of a convex cell where a distance is negative, from a regular sample of its bounding box.
inline double sampledFraction(
  const GridTopology& topology, Index cell, const std::function<double(const Vector&)>& distance)
{
  constexpr int n = 14;
  std::vector<Index> corners;
  topology.corners(cell, corners);
  Box box;
  for (Index corner : corners)
  {
    box.add(topology.point(corner));
  }
  CellFaces faces;
  topology.faces(cell, faces);
  const Vector center = topology.center(cell);
  const auto contains = [&](const Vector& x) {
    for (std::int32_t f = 0; f < faces.count(); ++f)
    {
      const Index* face = faces.corners.data() + faces.start[f];
      const Vector origin = topology.point(face[0]);
      const Vector normal = (topology.point(face[1]) - origin).cross(topology.point(face[2]) - origin);
      if (normal.dot(x - origin) * normal.dot(center - origin) < 0.0)
      {
        return false;
      }
    }
    return true;
  };
  int samples = 0;
  int hits = 0;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Vector at((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n);
    const Vector x = box.lower + at.cwiseProduct(box.size());
    if (contains(x))
    {
      ++samples;
      hits += distance(x) < 0.0 ? 1 : 0;
    }
  }
  return static_cast<double>(hits) / samples;
}

/// Two materials on a mesh of convex cells: the first where a distance is negative.
inline Simulation sampledSimulation(const UnstructuredGrid& mesh, const std::function<double(const Vector&)>& distance)
{
  Simulation simulation;
  simulation.grid.emplace<UnstructuredGrid>(mesh);
  simulation.materials = namedMaterials(2);
  Progress progress;
  const auto topology = makeGridTopology(mesh, progress);
  std::vector<double> inside;
  std::vector<double> rest;
  for (Index cell = 0; cell < mesh.cellCount(); ++cell)
  {
    inside.push_back(sampledFraction(*topology, cell, distance));
    rest.push_back(1.0 - inside.back());
  }
  simulation.fractions = { ownedArray(inside), ownedArray(rest) };
  return simulation;
}
}
