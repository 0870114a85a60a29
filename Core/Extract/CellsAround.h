#pragma once

#include "Extract/CellComplex.h"

#include <vector>

namespace strata
{
/// Which vertices a complex' cells have, and which of its cells lie round each vertex.
struct CellsAround
{
  explicit CellsAround(const CellComplex& complex);

  /// Nodes of cell c: nodes[nodeStart[c]] .. nodes[nodeStart[c + 1]], ascending.
  std::vector<std::int32_t> nodeStart;
  std::vector<std::int32_t> nodes;
  /// Cells round vertex v: cells[start[v]] .. cells[start[v + 1]], ascending.
  std::vector<std::int32_t> start;
  std::vector<std::int32_t> cells;

  template<typename Visit>
  void forEachVertex(const CellComplex& complex, std::int32_t cell, const Visit& visit) const
  {
    visit(complex.cellVertex(cell));
    for (std::int32_t i = complex.cellFaceStart[cell]; i < complex.cellFaceStart[cell + 1]; ++i)
    {
      visit(complex.faceVertex(complex.cellFaces[i].face));
    }
    for (std::int32_t i = nodeStart[cell]; i < nodeStart[cell + 1]; ++i)
    {
      visit(nodes[i]);
    }
  }
};
}
