#include "Extract/CellsAround.h"

#include <algorithm>

namespace strata
{
CellsAround::CellsAround(const CellComplex& complex)
{
  nodeStart.push_back(0);
  for (std::int32_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    const auto first = static_cast<std::ptrdiff_t>(nodes.size());
    for (std::int32_t i = complex.cellFaceStart[cell]; i < complex.cellFaceStart[cell + 1]; ++i)
    {
      const std::int32_t face = complex.cellFaces[i].face;
      nodes.insert(nodes.end(), complex.faceCorners.begin() + complex.faceStart[face],
        complex.faceCorners.begin() + complex.faceStart[face + 1]);
    }
    std::sort(nodes.begin() + first, nodes.end());
    nodes.erase(std::unique(nodes.begin() + first, nodes.end()), nodes.end());
    nodeStart.push_back(static_cast<std::int32_t>(nodes.size()));
  }
  start.assign(static_cast<std::size_t>(complex.vertexCount()) + 1, 0);
  for (std::int32_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    forEachVertex(complex, cell, [this](std::int32_t v) { ++start[v + 1]; });
  }
  for (std::size_t v = 1; v < start.size(); ++v)
  {
    start[v] += start[v - 1];
  }
  cells.resize(static_cast<std::size_t>(start.back()));
  std::vector<std::int32_t> next(start.begin(), start.end() - 1);
  for (std::int32_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    forEachVertex(complex, cell, [&](std::int32_t v) { cells[next[v]++] = cell; });
  }
}
}
