#pragma once

#include "Model/Grid.h"

namespace strata
{
/// The faces of a cell's shape as positions among its corners, counter-clockwise as seen from outside; -1 ends a
/// triangle. No faces for polyhedra, whose faces the grid lists.
struct ShapeFaces
{
  const int (*faces)[4];
  int count;

  const int (*begin() const)[4] { return faces; }
  const int (*end() const)[4] { return faces + count; }
};

ShapeFaces facesOf(CellShape shape);

/// The number of corners of one of these faces.
inline int cornerCount(const int (&face)[4])
{
  return face[3] < 0 ? 3 : 4;
}
}
