#pragma once

#include "Model/Progress.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace strata
{
/// Calls visit(i) for i in [0, count) from several threads.
template<typename Count, typename Visit>
void forEach(Count count, Progress& progress, const Visit& visit)
{
  constexpr Count grain = 256;
  tbb::parallel_for(tbb::blocked_range<Count>(0, count, grain), [&](const tbb::blocked_range<Count>& range) {
    progress.check();
    for (Count i = range.begin(); i < range.end(); ++i)
    {
      visit(i);
    }
  });
}
}
