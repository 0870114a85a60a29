#include "Extract/PassOn.h"

#include <algorithm>

namespace strata
{
namespace
{
/// How far volume moves at most, in rings of cells, to get to the interface.
constexpr int rings = 3;

/// Calls visit(cell) for the cells that share a node with a cell, itself included; cells may come repeatedly.
template<typename Visit>
void forEachNeighbour(const CellsAround& around, std::int32_t cell, const Visit& visit)
{
  for (std::int32_t i = around.nodeStart[cell]; i < around.nodeStart[cell + 1]; ++i)
  {
    const std::int32_t node = around.nodes[i];
    for (std::int32_t k = around.start[node]; k < around.start[node + 1]; ++k)
    {
      visit(around.cells[k]);
    }
  }
}

/// Half the area in which two materials' regions touch in a cell.
double contact(const CellVolume& cell, std::uint8_t a, std::uint8_t b)
{
  Eigen::Index rows[2] = { -1, -1 };
  for (std::size_t i = 0; i < cell.volumes.size() && cell.volumes.size() > 1; ++i)
  {
    rows[0] = cell.volumes[i].material == a ? static_cast<Eigen::Index>(i) : rows[0];
    rows[1] = cell.volumes[i].material == b ? static_cast<Eigen::Index>(i) : rows[1];
  }
  return rows[0] >= 0 && rows[1] >= 0 ? std::max(0.0, -cell.slopes(rows[0], rows[1])) : 0.0;
}
}

void addTo(std::vector<Share>& shares, std::uint8_t material, double value)
{
  const auto same = [&](const Share& share) { return share.material == material; };
  const auto found = std::find_if(shares.begin(), shares.end(), same);
  if (found == shares.end())
  {
    shares.push_back({ material, value });
  }
  else
  {
    found->value += value;
  }
}

void PassOn::give(std::int32_t cell, const std::vector<Share>& lacking, std::vector<std::vector<Share>>& received)
{
  double sum = 0.0;
  for (const Share& share : lacking)
  {
    sum += std::max(0.0, share.value);
  }
  for (const Share& more : lacking)
  {
    for (const Share& less : lacking)
    {
      if (more.value <= 0.0 || less.value >= 0.0)
      {
        continue;
      }
      find(cell, more.material, less.material);
      const double amount = more.value * -less.value / sum;
      for (const auto& [to, area] : cells_)
      {
        addTo(received[to], more.material, amount * area / area_);
        addTo(received[to], less.material, -amount * area / area_);
      }
    }
  }
}

void PassOn::find(std::int32_t cell, std::uint8_t a, std::uint8_t b)
{
  cells_.clear();
  area_ = 0.0;
  ++search_;
  seen_[cell] = search_;
  ring_.assign(1, cell);
  take(cell, a, b);
  for (int r = 0; r < rings && (r == 0 || cells_.empty()); ++r)
  {
    next_.clear();
    for (const std::int32_t from : ring_)
    {
      forEachNeighbour(around_, from, [&](std::int32_t to) {
        if (seen_[to] != search_)
        {
          seen_[to] = search_;
          next_.push_back(to);
          take(to, a, b);
        }
      });
    }
    ring_.swap(next_);
  }
  if (cells_.empty())
  {
    cells_.push_back({ cell, 1.0 });
    area_ = 1.0;
  }
}

void PassOn::take(std::int32_t cell, std::uint8_t a, std::uint8_t b)
{
  const double own = contact(volumes_[cell], a, b);
  if (own > 0.0)
  {
    cells_.push_back({ cell, own });
    area_ += own;
  }
}
}
