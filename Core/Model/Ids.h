#pragma once

#include <cstdint>

namespace strata
{
/// Counts and positions in arrays.
using Index = std::int64_t;

/// An id that can't be mistaken for another kind of id; -1 means none.
template<typename Tag>
struct Id
{
  std::int32_t value = -1;

  constexpr Id() = default;
  constexpr explicit Id(std::int64_t v) : value(static_cast<std::int32_t>(v)) {}
  constexpr bool valid() const { return value >= 0; }
  friend constexpr bool operator==(Id a, Id b) { return a.value == b.value; }
  friend constexpr bool operator!=(Id a, Id b) { return a.value != b.value; }
  friend constexpr bool operator<(Id a, Id b) { return a.value < b.value; }
};

using MaterialId = Id<struct MaterialTag>;
using FieldId = Id<struct FieldTag>;
}
