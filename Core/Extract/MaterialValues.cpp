#include "Extract/MaterialValues.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata
{
namespace
{
/// The mean of several lists of shares, added up in the given order.
std::vector<Share> mean(const std::vector<std::vector<Share>>& lists)
{
  std::vector<Share> sum;
  for (const std::vector<Share>& list : lists)
  {
    for (const Share& share : list)
    {
      const auto same = [&](const Share& s) { return s.material == share.material; };
      const auto found = std::find_if(sum.begin(), sum.end(), same);
      if (found == sum.end())
      {
        sum.push_back(share);
      }
      else
      {
        found->value += share.value;
      }
    }
  }
  for (Share& share : sum)
  {
    share.value /= static_cast<double>(lists.size());
  }
  std::sort(sum.begin(), sum.end(), [](const Share& a, const Share& b) { return a.material < b.material; });
  return sum;
}

std::vector<Share> meanOf(const std::vector<Index>& ids, const Fractions& fractions, bool points)
{
  std::vector<std::vector<Share>> lists(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    points ? fractions.ofPoint(ids[i], lists[i]) : fractions.ofCell(ids[i], lists[i]);
  }
  return mean(lists);
}

std::vector<Share> sharesAt(std::int32_t vertex, const CellComplex& complex, const Fractions& fractions)
{
  std::vector<Share> shares;
  if (vertex < complex.nodeCount())
  {
    fractions.ofPoint(complex.nodes[vertex], shares);
    return shares;
  }
  const std::int32_t face = vertex - complex.nodeCount();
  if (face >= complex.faceCount())
  {
    fractions.ofCell(complex.cells[face - complex.faceCount()], shares);
    return shares;
  }
  std::vector<Index> ids;
  if (fractions.atPoints())
  {
    for (std::int32_t i = complex.faceStart[face]; i < complex.faceStart[face + 1]; ++i)
    {
      ids.push_back(complex.nodes[complex.faceCorners[i]]);
    }
    std::sort(ids.begin(), ids.end());
    return meanOf(ids, fractions, true);
  }
  ids.push_back(complex.faceCells[face][0]);
  if (complex.faceCells[face][1] >= 0)
  {
    ids.push_back(complex.faceCells[face][1]);
  }
  return meanOf(ids, fractions, false);
}
}

MaterialValues makeMaterialValues(const CellComplex& complex, const Fractions& fractions, Progress& progress)
{
  constexpr std::int32_t blockSize = 1024;
  const std::int32_t blockCount = (complex.vertexCount() + blockSize - 1) / blockSize;
  std::vector<MaterialValues> blocks(static_cast<std::size_t>(blockCount));
  tbb::parallel_for(std::int32_t{ 0 }, blockCount, [&](std::int32_t b) {
    progress.check();
    MaterialValues& block = blocks[b];
    for (std::int32_t v = b * blockSize; v < std::min((b + 1) * blockSize, complex.vertexCount()); ++v)
    {
      for (const Share& share : sharesAt(v, complex, fractions))
      {
        block.materials.push_back(share.material);
        block.values.push_back(share.value);
      }
      block.start.push_back(static_cast<Index>(block.values.size()));
    }
  });
  MaterialValues result;
  result.start.push_back(0);
  for (const MaterialValues& block : blocks)
  {
    const auto offset = static_cast<Index>(result.values.size());
    for (Index end : block.start)
    {
      result.start.push_back(offset + end);
    }
    result.materials.insert(result.materials.end(), block.materials.begin(), block.materials.end());
    result.values.insert(result.values.end(), block.values.begin(), block.values.end());
  }
  return result;
}
}
