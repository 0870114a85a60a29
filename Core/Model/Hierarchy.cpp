#include "Model/Hierarchy.h"

namespace strata
{
namespace
{
constexpr std::size_t smallestTable = 64;

std::size_t hashOf(const LatticePoint& point)
{
  // Odd 64-bit multipliers spread the low bits, which are mostly zero, over the word.
  std::uint64_t h = static_cast<std::uint64_t>(point[0]) * 0x9E3779B97F4A7C15ull;
  h ^= static_cast<std::uint64_t>(point[1]) * 0xC2B2AE3D27D4EB4Full;
  h ^= static_cast<std::uint64_t>(point[2]) * 0x165667B19E3779F9ull;
  h ^= h >> 32;
  h *= 0xD6E8FEB86659FD93ull;
  return static_cast<std::size_t>(h ^ (h >> 29));
}
}

std::size_t DiamondTable::slotOf(const LatticePoint& center, const std::vector<Diamond>& diamonds) const
{
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hashOf(center) & mask;
  while (slots_[slot].valid() && !(diamonds[static_cast<std::size_t>(slots_[slot].value)].center == center))
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

DiamondId DiamondTable::find(const LatticePoint& center, const std::vector<Diamond>& diamonds) const
{
  return slots_.empty() ? DiamondId() : slots_[slotOf(center, diamonds)];
}

void DiamondTable::insert(DiamondId id, const std::vector<Diamond>& diamonds)
{
  if (2 * (used_ + 1) > slots_.size())
  {
    std::vector<DiamondId> old(slots_.empty() ? smallestTable : 2 * slots_.size());
    old.swap(slots_);
    for (const DiamondId entry : old)
    {
      if (entry.valid())
      {
        slots_[slotOf(diamonds[static_cast<std::size_t>(entry.value)].center, diamonds)] = entry;
      }
    }
  }
  slots_[slotOf(diamonds[static_cast<std::size_t>(id.value)].center, diamonds)] = id;
  ++used_;
}

void DiamondTable::renumber(const std::vector<std::int32_t>& newPlaces)
{
  for (DiamondId& slot : slots_)
  {
    slot = slot.valid() ? DiamondId(newPlaces[static_cast<std::size_t>(slot.value)]) : slot;
  }
}

const float* Hierarchy::valuesOf(VertexId vertex, MaterialId m) const
{
  const auto v = static_cast<std::size_t>(vertex.value);
  if (!vertexMaterials[v].contains(m))
  {
    return nullptr;
  }
  const int rank = vertexMaterials[v].rank(m);
  return values.data() + valueOffsets[v] + static_cast<Index>(rank) * valuesPerMaterial;
}
}
