#pragma once

#include "Model/Mesh.h"

namespace strata
{
/// A representation that somebody else owns (an emitted Mesh, or a grid loaded from a file), to be sliced,
/// cut into pieces, sampled and measured. Same layout as Mesh; a null pointer stands for an absent array.
struct Representation
{
  Materials materials;
  std::vector<Field> fields;
  Index vertexCount = 0;
  Index cellCount = 0;
  const double* points = nullptr;
  const std::int64_t* tetrahedra = nullptr;
  std::vector<const float*> distances;           ///< [material]
  std::vector<std::vector<const float*>> values; ///< [field][material]

  Vector point(Index vertex) const { return { points[3 * vertex], points[3 * vertex + 1], points[3 * vertex + 2] }; }
};

/// A view of a mesh; the mesh must outlive it.
Representation view(const Mesh& mesh);

/// The materials that a cell may hold: those whose distance is a number at all four vertices.
MaterialSet materialsOfCell(const Representation& representation, Index cell);
}
