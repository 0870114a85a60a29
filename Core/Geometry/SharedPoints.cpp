#include "Geometry/SharedPoints.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <memory>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<std::int64_t>;

bool same(const PointUse& a, const PointUse& b)
{
  return a.owner == b.owner && a.point.key == b.point.key;
}

/// An open hash table that several threads fill. A slot holds the lowest use of its point; slots never empty again,
/// so each point ends in one slot.
class UseTable
{
public:
  explicit UseTable(const std::vector<PointUse>& uses) : uses_(uses)
  {
    while (mask_ < 2 * uses.size())
    {
      mask_ = 2 * mask_ + 1;
    }
    slots_.reset(new std::atomic<std::int64_t>[mask_ + 1]);
    tbb::parallel_for(Range(0, static_cast<std::int64_t>(mask_) + 1, 4096), [this](const Range& range) {
      for (std::int64_t slot = range.begin(); slot != range.end(); ++slot)
      {
        slots_[slot].store(-1, std::memory_order_relaxed);
      }
    });
  }

  /// Enters a use; returns its slot.
  std::int64_t insert(std::int64_t use)
  {
    const std::size_t hash =
      CutKeyHash()(uses_[use].point.key) + static_cast<std::size_t>(uses_[use].owner) * 0x9E3779B1u;
    std::size_t slot = (hash ^ hash >> 32) & mask_;
    while (!insertAt(slot, use))
    {
      slot = (slot + 1) & mask_;
    }
    return static_cast<std::int64_t>(slot);
  }
  std::int64_t lowestUse(std::int64_t slot) const { return slots_[slot].load(std::memory_order_relaxed); }

private:
  bool insertAt(std::size_t slot, std::int64_t use)
  {
    std::int64_t present = slots_[slot].load(std::memory_order_relaxed);
    if (present < 0 && slots_[slot].compare_exchange_strong(present, use, std::memory_order_relaxed))
    {
      return true;
    }
    if (!same(uses_[present], uses_[use]))
    {
      return false;
    }
    while (use < present && !slots_[slot].compare_exchange_weak(present, use, std::memory_order_relaxed))
    {}
    return true;
  }

  const std::vector<PointUse>& uses_;
  std::size_t mask_ = 15;
  std::unique_ptr<std::atomic<std::int64_t>[]> slots_;
};
}

SharedPoints sharePoints(const std::vector<PointUse>& uses)
{
  const std::int64_t count = static_cast<std::int64_t>(uses.size());
  SharedPoints result;
  result.numbers.resize(uses.size());
  UseTable table(uses);
  tbb::parallel_for(Range(0, count, 2048), [&](const Range& range) {
    for (std::int64_t use = range.begin(); use != range.end(); ++use)
    {
      result.numbers[use] = table.insert(use);
    }
  });
  // A first use comes before the others, so one pass numbers the points.
  for (std::int64_t use = 0; use < count; ++use)
  {
    const std::int64_t first = table.lowestUse(result.numbers[use]);
    if (first == use)
    {
      result.numbers[use] = static_cast<std::int64_t>(result.firstUse.size());
      result.firstUse.push_back(use);
    }
    else
    {
      result.numbers[use] = result.numbers[first];
    }
  }
  return result;
}
}
