#pragma once

#include "Extract/CellComplex.h"
#include "Extract/Fractions.h"

#include <vector>

namespace strata
{
/// One number per material at every vertex of a complex: at each point the material with the largest wins, the
/// lowest of equals.
struct MaterialValues
{
  /// Entries of vertex v: start[v] .. start[v + 1], by ascending material.
  std::vector<Index> start;
  std::vector<std::uint8_t> materials;
  std::vector<double> values;
  /// By vertex: the value of the materials that it doesn't list; empty stands for 0.
  std::vector<double> absent;

  /// The material that wins at a vertex.
  std::uint8_t winner(std::int32_t vertex) const
  {
    Index best = start[vertex];
    for (Index i = best + 1; i < start[vertex + 1]; ++i)
    {
      best = values[i] > values[best] ? i : best;
    }
    return materials[best];
  }
  /// The entry of a material at a vertex; -1 if it isn't listed.
  Index find(std::int32_t vertex, std::uint8_t material) const
  {
    for (Index i = start[vertex]; i < start[vertex + 1]; ++i)
    {
      if (materials[i] == material)
      {
        return i;
      }
    }
    return -1;
  }
  /// The value of a material at a vertex.
  double at(std::int32_t vertex, std::uint8_t material) const
  {
    const Index entry = find(vertex, material);
    return entry >= 0 ? values[entry] : absent.empty() ? 0.0 : absent[vertex];
  }
};

/// The fractions at cell centres; their means over the cells around at points and face centres. For data at
/// points those, and their means over the corners at face and cell centres.
MaterialValues makeMaterialValues(const CellComplex& complex, const Fractions& fractions, Progress& progress);
}
