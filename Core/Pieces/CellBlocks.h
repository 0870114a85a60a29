#pragma once

#include "Model/CellDistances.h"
#include "Model/Progress.h"

#include "Geometry/CutTetrahedron.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace strata
{
/// What a thread needs to cut cells.
struct CutWorkspace
{
  TetrahedronCut cut;
  std::vector<CornerValues> distances;
  std::vector<std::array<int, 4>> pieces;
};

/// Calls work(cell, workspace, block) for all cells, threaded, with one block per run of cells. The blocks, in the
/// order of their cells, don't depend on the number of threads.
template<typename Block, typename Work>
std::vector<Block> forCellBlocks(Index cellCount, Progress& progress, const Work& work)
{
  constexpr Index cellsPerBlock = 2048;
  const Index blockCount = (cellCount + cellsPerBlock - 1) / cellsPerBlock;
  std::vector<Block> blocks(static_cast<std::size_t>(blockCount));
  tbb::enumerable_thread_specific<CutWorkspace> workspaces;
  tbb::parallel_for(tbb::blocked_range<Index>(0, blockCount, 1), [&](const tbb::blocked_range<Index>& range) {
    CutWorkspace& workspace = workspaces.local();
    for (Index block = range.begin(); block != range.end(); ++block)
    {
      progress.check();
      for (Index cell = block * cellsPerBlock; cell < std::min(cellCount, (block + 1) * cellsPerBlock); ++cell)
      {
        work(cell, workspace, blocks[block]);
      }
    }
  });
  return blocks;
}
}
