#pragma once

#include "Model/Buffer.h"
#include "Model/Level.h"
#include "Model/Progress.h"

namespace strata
{
/// A level's cells and vertices, taken from the hierarchy once: what comes after runs through memory in order.
struct LevelCells
{
  std::vector<CellId> cells;       ///< in the order of the bisection trees: a function of the mesh alone
  Buffer<std::int64_t> tetrahedra; ///< 4 numbers of vertices per cell, positively oriented
  std::vector<VertexId> vertices;  ///< [number], in the order of their first use
  std::vector<MaterialSet> needs;  ///< [number], the materials that the cells round the vertex hold

  /// The materials that have values at all corners of a cell: those that a reader of the mesh finds in it.
  MaterialSet atAllCorners(std::size_t cell) const
  {
    const std::int64_t* corners = tetrahedra.data() + 4 * cell;
    return needs[corners[0]] & needs[corners[1]] & needs[corners[2]] & needs[corners[3]];
  }
};

LevelCells levelCells(const Hierarchy& hierarchy, const Level& level, Progress& progress);

/// The cells alone.
std::vector<CellId> leafCells(const Hierarchy& hierarchy, const Level& level);
}
