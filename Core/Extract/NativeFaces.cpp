#include "Extract/NativeFaces.h"

#include <algorithm>

namespace strata
{
namespace
{
// Faces of the linear cells by VTK's corner numbers, counter-clockwise as seen from outside; -1 ends a triangle.
constexpr int tetrahedronFaces[4][4] = { { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 2, 0, 3, -1 }, { 0, 2, 1, -1 } };
constexpr int hexahedronFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 },
  { 4, 5, 6, 7 } };
constexpr int wedgeFaces[5][4] = { { 0, 1, 2, -1 }, { 3, 5, 4, -1 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } };
constexpr int pyramidFaces[5][4] = { { 0, 3, 2, 1 }, { 0, 1, 4, -1 }, { 1, 2, 4, -1 }, { 2, 3, 4, -1 },
  { 3, 0, 4, -1 } };

struct FaceTable
{
  const int (*faces)[4];
  int count;
};

FaceTable tableOf(CellShape shape)
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

void endFace(CellFaces& faces)
{
  faces.start.push_back(static_cast<std::int32_t>(faces.corners.size()));
  faces.neighbours.push_back(-1);
}

bool isListed(const Index* corners, std::size_t count, Index corner)
{
  return std::find(corners, corners + count, corner) != corners + count;
}
}

void addNativeFaces(const UnstructuredGrid& grid, Index cell, CellFaces& faces)
{
  if (grid.shapes[cell] == CellShape::Polyhedron)
  {
    for (Index f = grid.faceOffsets[cell]; f < grid.faceOffsets[cell + 1]; ++f)
    {
      faces.corners.insert(faces.corners.end(), grid.faceCorners.begin() + grid.faceStart[f],
        grid.faceCorners.begin() + grid.faceStart[f + 1]);
      endFace(faces);
    }
    return;
  }
  const FaceTable table = tableOf(grid.shapes[cell]);
  const Index* corner = grid.corners.data() + grid.cornerOffsets[cell];
  for (int f = 0; f < table.count; ++f)
  {
    for (int i = 0; i < 4 && table.faces[f][i] >= 0; ++i)
    {
      faces.corners.push_back(corner[table.faces[f][i]]);
    }
    endFace(faces);
  }
}

bool hasNativeFace(const UnstructuredGrid& grid, Index cell, const Index* corners, std::size_t count)
{
  if (grid.shapes[cell] == CellShape::Polyhedron)
  {
    for (Index f = grid.faceOffsets[cell]; f < grid.faceOffsets[cell + 1]; ++f)
    {
      const Index* first = grid.faceCorners.data() + grid.faceStart[f];
      const Index* last = grid.faceCorners.data() + grid.faceStart[f + 1];
      if (static_cast<std::size_t>(last - first) == count &&
          std::all_of(first, last, [&](Index corner) { return isListed(corners, count, corner); }))
      {
        return true;
      }
    }
    return false;
  }
  const Index first = grid.cornerOffsets[cell];
  unsigned shared = 0;
  for (Index i = first; i < grid.cornerOffsets[cell + 1]; ++i)
  {
    shared |= isListed(corners, count, grid.corners[i]) ? 1u << (i - first) : 0u;
  }
  if (static_cast<std::size_t>(__builtin_popcount(shared)) != count)
  {
    return false;
  }
  const FaceTable table = tableOf(grid.shapes[cell]);
  for (int f = 0; f < table.count; ++f)
  {
    unsigned face = 0;
    std::size_t size = 0;
    for (int i = 0; i < 4 && table.faces[f][i] >= 0; ++i, ++size)
    {
      face |= 1u << table.faces[f][i];
    }
    if (size == count && face == shared)
    {
      return true;
    }
  }
  return false;
}
}
