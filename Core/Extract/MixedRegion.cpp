#include "Extract/MixedRegion.h"

#include "Extract/ForEach.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// By how much the dominant material leads at an outer vertex at least, as a part of the cell's size.
constexpr double leastLead = 1e-3;

std::vector<std::uint8_t> findOuterVertices(
  const CellComplex& complex, const CellsAround& around, const GridTopology& topology, Progress& progress)
{
  std::vector<std::uint8_t> outer(static_cast<std::size_t>(complex.vertexCount()), 0);
  forEach(complex.nodeCount(), progress, [&](std::int32_t v) {
    std::vector<Index> cells;
    topology.cellsAround(complex.nodes[v], cells);
    outer[v] = static_cast<Index>(cells.size()) != around.start[v + 1] - around.start[v] ? 1 : 0;
  });
  forEach(complex.faceCount(), progress, [&](std::int32_t f) {
    const std::int32_t v = complex.faceVertex(f);
    const int cells = complex.faceCells[f][1] < 0 ? 1 : 2;
    outer[v] = around.start[v + 1] - around.start[v] != cells ? 1 : 0;
  });
  return outer;
}
}

MixedRegion::MixedRegion(const GridTopology& topologyOfGrid, const Fractions& fractionsOfGrid, double minimumFraction,
  const std::vector<std::uint8_t>& also, Progress& progress) :
  topology(topologyOfGrid),
  fractions(fractionsOfGrid), mixed(findMixedCells(fractions, topology, minimumFraction, also, progress)),
  complex(makeCellComplex(topology, mixed.cells, progress)), around(complex),
  outer(findOuterVertices(complex, around, topology, progress))
{}

void keepInterfacesInside(const MixedRegion& region, MaterialValues& values, Progress& progress)
{
  forEach(region.complex.vertexCount(), progress, [&](std::int32_t v) {
    if (!region.outer[v])
    {
      return;
    }
    const std::int32_t cell = region.around.cells[region.around.start[v]];
    const Index dominant = values.find(v, region.mixed.dominant[region.complex.cells[cell]]);
    const double lead = leastLead * std::abs(values.absent[v]);
    values.values[dominant] = std::max(values.values[dominant], lead);
    for (Index i = values.start[v]; i < values.start[v + 1]; ++i)
    {
      values.values[i] = i == dominant ? values.values[i] : std::min(values.values[i], values.values[dominant] - lead);
    }
  });
}
}
