#include "Extract/NativeFaces.h"

#include "Model/ShapeFaces.h"

#include <algorithm>

namespace strata
{
namespace
{
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
  const Index* corner = grid.corners.data() + grid.cornerOffsets[cell];
  for (const auto& face : facesOf(grid.shapes[cell]))
  {
    for (int i = 0; i < cornerCount(face); ++i)
    {
      faces.corners.push_back(corner[face[i]]);
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
  for (const auto& face : facesOf(grid.shapes[cell]))
  {
    const int size = cornerCount(face);
    unsigned own = 0;
    for (int i = 0; i < size; ++i)
    {
      own |= 1u << face[i];
    }
    if (static_cast<std::size_t>(size) == count && own == shared)
    {
      return true;
    }
  }
  return false;
}
}
