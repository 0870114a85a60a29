#include "Measure/FaceJumps.h"

#include "Measure/CellRegions.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr Index itemsPerBlock = 1024;

/// A cell's face.
struct Face
{
  std::array<std::int64_t, 3> vertices; ///< ascending
  Index cell = 0;
  int opposite = 0;

  friend bool operator<(const Face& a, const Face& b)
  {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.cell < b.cell;
  }
};

Face faceOf(const Representation& representation, Index cell, int opposite)
{
  Face face;
  face.cell = cell;
  face.opposite = opposite;
  int count = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (i != opposite)
    {
      face.vertices[count++] = representation.tetrahedra[4 * cell + i];
    }
  }
  std::sort(face.vertices.begin(), face.vertices.end());
  return face;
}

/// Whether all vertices of a face have the distances of at least two materials: otherwise both its cells hold the same
/// single one.
bool mayDivide(const Representation& representation, const Face& face)
{
  const auto holds = [&](const float* distance) {
    return distance && std::none_of(face.vertices.begin(), face.vertices.end(),
                         [&](std::int64_t vertex) { return std::isnan(distance[vertex]); });
  };
  return std::count_if(representation.distances.begin(), representation.distances.end(), holds) > 1;
}

Index blocksOf(Index items)
{
  return (items + itemsPerBlock - 1) / itemsPerBlock;
}

void addFacesThatMayDivide(const Representation& representation, Index cell, std::vector<Face>& faces)
{
  for (int opposite = 0; opposite < 4; ++opposite)
  {
    const Face face = faceOf(representation, cell, opposite);
    if (mayDivide(representation, face))
    {
      faces.push_back(face);
    }
  }
}

std::vector<Face> facesThatMayDivide(const Representation& representation, Progress& progress)
{
  std::vector<std::vector<Face>> blocks(static_cast<std::size_t>(blocksOf(representation.cellCount)));
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(), [&](std::size_t block) {
    progress.check();
    const Index begin = static_cast<Index>(block) * itemsPerBlock;
    for (Index cell = begin; cell < std::min(begin + itemsPerBlock, representation.cellCount); ++cell)
    {
      addFacesThatMayDivide(representation, cell, blocks[block]);
    }
  });
  std::vector<Face> faces;
  for (const std::vector<Face>& block : blocks)
  {
    faces.insert(faces.end(), block.begin(), block.end());
  }
  tbb::parallel_sort(faces.begin(), faces.end());
  return faces;
}

/// The faces between two cells that hold different sets of materials, each with both sides.
std::vector<std::array<Face, 2>> facesThatDiffer(const Representation& representation, const std::vector<Face>& faces)
{
  std::vector<std::array<Face, 2>> result;
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
  {
    if (faces[i].vertices == faces[i + 1].vertices &&
        materialsOfCell(representation, faces[i].cell) != materialsOfCell(representation, faces[i + 1].cell))
    {
      result.push_back({ faces[i], faces[i + 1] });
    }
  }
  return result;
}

/// Newell's normal of a planar polygon, twice its area long.
Vector areaNormal(const std::vector<Vector>& polygon)
{
  Vector normal = Vector::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    normal += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return normal;
}

/// The part of a convex polygon in another convex polygon of the same plane (Sutherland and Hodgman).
std::vector<Vector> intersection(std::vector<Vector> polygon, const std::vector<Vector>& other)
{
  const Vector normal = areaNormal(other);
  for (std::size_t i = 0; i < other.size() && !polygon.empty(); ++i)
  {
    const Vector inward = normal.cross(other[(i + 1) % other.size()] - other[i]);
    std::vector<Vector> rest;
    for (std::size_t j = 0; j < polygon.size(); ++j)
    {
      const Vector& a = polygon[j];
      const Vector& b = polygon[(j + 1) % polygon.size()];
      const double heightA = inward.dot(a - other[i]);
      const double heightB = inward.dot(b - other[i]);
      if (heightA >= 0.0)
      {
        rest.push_back(a);
      }
      if ((heightA < 0.0) != (heightB < 0.0) && heightA != 0.0 && heightB != 0.0)
      {
        rest.push_back(a + (b - a) * (heightA / (heightA - heightB)));
      }
    }
    polygon = std::move(rest);
  }
  return polygon;
}

void addJumps(CellRegions& first, CellRegions& second, const std::array<Face, 2>& sides, PairSurfaces& surfaces)
{
  first.divide(sides[0].cell);
  second.divide(sides[1].cell);
  if (first.materials() == second.materials() && first.materials().size() == 1)
  {
    return;
  }
  const std::vector<CellRegions::FacePart> secondParts = second.faceParts();
  for (const CellRegions::FacePart& part : first.faceParts())
  {
    for (const CellRegions::FacePart& other : secondParts)
    {
      if (part.opposite != sides[0].opposite || other.opposite != sides[1].opposite || part.material == other.material)
      {
        continue;
      }
      const std::vector<Vector> common = intersection(part.corners, other.corners);
      if (areaNormal(common).squaredNorm() > 0.0)
      {
        addPolygon(surfaces[orderedPair(part.material, other.material)], common);
      }
    }
  }
}
}

PairSurfaces surfacesOnFaces(const Representation& representation, Progress& progress)
{
  const std::vector<std::array<Face, 2>> differing =
    facesThatDiffer(representation, facesThatMayDivide(representation, progress));
  std::vector<PairSurfaces> blocks(static_cast<std::size_t>(blocksOf(static_cast<Index>(differing.size()))));
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(), [&](std::size_t block) {
    progress.check();
    CellRegions first(representation);
    CellRegions second(representation);
    const std::size_t begin = block * itemsPerBlock;
    for (std::size_t i = begin; i < std::min(begin + itemsPerBlock, differing.size()); ++i)
    {
      addJumps(first, second, differing[i], blocks[block]);
    }
  });
  PairSurfaces result;
  for (const PairSurfaces& block : blocks)
  {
    for (const auto& [pair, soup] : block)
    {
      std::vector<std::array<Vector, 3>>& triangles = result[pair].triangles;
      triangles.insert(triangles.end(), soup.triangles.begin(), soup.triangles.end());
    }
  }
  return result;
}
}
