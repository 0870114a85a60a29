#pragma once

#include "Model/Level.h"

namespace strata
{
/// The cells of a level in the order of the bisection trees: a function of the mesh alone.
std::vector<CellId> leafCells(const Hierarchy& hierarchy, const Level& level);

/// The vertices of a list of cells, numbered in the order of their first use.
struct VertexNumbering
{
  std::vector<std::int32_t> numberOf; ///< [hierarchy vertex], -1 if unused
  std::vector<VertexId> vertices;     ///< [number]
};
VertexNumbering numberVertices(const Hierarchy& hierarchy, const std::vector<CellId>& cells);
}
