#include "Conversion/RepeatedCells.h"

#include "Model/MixedBits.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace strata::conversion
{
namespace
{
std::vector<Index> sortedCorners(const UnstructuredGrid& grid, Index cell)
{
  const auto c = static_cast<std::size_t>(cell);
  std::vector<Index> corners(
    grid.corners.begin() + grid.cornerOffsets[c], grid.corners.begin() + grid.cornerOffsets[c + 1]);
  std::sort(corners.begin(), corners.end());
  return corners;
}
}

std::vector<std::pair<Index, Index>> repeatedCells(const UnstructuredGrid& grid)
{
  // Sums of the corners' numbers don't depend on their order; only cells with equal sums are compared.
  std::vector<std::pair<std::uint64_t, Index>> sums(grid.shapes.size());
  for (std::size_t c = 0; c < sums.size(); ++c)
  {
    sums[c].second = static_cast<Index>(c);
    for (Index k = grid.cornerOffsets[c]; k < grid.cornerOffsets[c + 1]; ++k)
    {
      sums[c].first += mixedBits(static_cast<std::uint64_t>(grid.corners[static_cast<std::size_t>(k)]));
    }
  }
  tbb::parallel_sort(sums.begin(), sums.end());
  std::vector<std::pair<Index, Index>> result;
  std::size_t first = 0;
  for (std::size_t i = 1; i < sums.size(); ++i)
  {
    if (sums[i].first != sums[first].first)
    {
      first = i;
    }
    else if (sortedCorners(grid, sums[i].second) == sortedCorners(grid, sums[first].second))
    {
      result.emplace_back(sums[i].second, sums[first].second);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}
}
