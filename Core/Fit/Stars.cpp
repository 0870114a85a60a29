#include "Fit/Stars.h"

#include <algorithm>

namespace strata
{
Stars::Stars(const Hierarchy& values, const std::vector<CellId>& cells, std::vector<VertexId> vertices) :
  indexOf_(values.vertices.size(), -1), vertices_(std::move(vertices))
{
  for (std::size_t i = 0; i < vertices_.size(); ++i)
  {
    indexOf_[static_cast<std::size_t>(vertices_[i].value)] = static_cast<std::int32_t>(i);
  }
  findCells(values, cells);
  color(values, cells);
}

void Stars::findCells(const Hierarchy& values, const std::vector<CellId>& cells)
{
  cellsAt_.resize(vertices_.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (const VertexId corner : values.cell(cells[c]).corners)
    {
      const std::int32_t index = indexOf_[static_cast<std::size_t>(corner.value)];
      if (index >= 0)
      {
        cellsAt_[static_cast<std::size_t>(index)].push_back(c);
      }
    }
  }
}

void Stars::color(const Hierarchy& values, const std::vector<CellId>& cells)
{
  std::vector<int> colorOf(vertices_.size(), -1);
  std::vector<bool> taken;
  for (std::size_t i = 0; i < vertices_.size(); ++i)
  {
    taken.assign(colors_.size() + 1, false);
    for (const std::size_t c : cellsAt_[i])
    {
      for (const VertexId corner : values.cell(cells[c]).corners)
      {
        const std::int32_t other = indexOf_[static_cast<std::size_t>(corner.value)];
        if (other >= 0 && colorOf[static_cast<std::size_t>(other)] >= 0)
        {
          taken[static_cast<std::size_t>(colorOf[static_cast<std::size_t>(other)])] = true;
        }
      }
    }
    const auto free = static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    colors_.resize(std::max(colors_.size(), free + 1));
    colors_[free].push_back(i);
    colorOf[i] = static_cast<int>(free);
  }
}
}
