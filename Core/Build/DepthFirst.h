#pragma once

#include "Model/Hierarchy.h"
#include "Model/Progress.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <utility>

namespace strata
{
/// Another order of a hierarchy's cells, diamonds and vertices: the old place of each.
struct HierarchyOrder
{
  std::vector<std::int32_t> cells;
  std::vector<std::int32_t> diamonds;
  std::vector<std::int32_t> vertices;
};

/// The base mesh, then each split cell's two children followed by what is below the first and below the second;
/// diamonds and vertices by their first cells. Levels run through memory in this order.
HierarchyOrder depthFirst(const Hierarchy& hierarchy, Progress& progress);

/// Brings cells, diamonds and vertices into an order, which must keep the base mesh first and children beside each
/// other. The hierarchy is of no use any more if the user stops this.
void reorder(Hierarchy& hierarchy, const HierarchyOrder& order, Progress& progress);

/// Brings an array of `width` values a place into an order.
template<typename T>
void reorder(std::vector<T>& values, const std::vector<std::int32_t>& order, std::size_t width = 1)
{
  std::vector<T> result(values.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, order.size(), 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
    {
      for (std::size_t k = 0; k < width; ++k)
      {
        result[i * width + k] = std::move(values[static_cast<std::size_t>(order[i]) * width + k]);
      }
    }
  });
  values.swap(result);
}
}
