#pragma once

#include "Model/Ids.h"

#include <cstdint>
#include <string>
#include <vector>

namespace strata
{
/// A region that takes part in filling the box. *Empty* and *outside* are materials without fields.
struct Material
{
  std::string name;
  bool hasFields = true;
};

/// The materials of a data set; a MaterialId is a position in it.
using Materials = std::vector<Material>;

/// A set of materials. It holds ids 0 to MaterialSet::capacity - 1.
class MaterialSet
{
public:
  static constexpr int capacity = 64;

  constexpr MaterialSet() = default;
  static MaterialSet of(MaterialId m) { return MaterialSet(std::uint64_t{ 1 } << m.value); }

  static MaterialSet fromBits(std::uint64_t bits) { return MaterialSet(bits); }
  std::uint64_t bits() const { return bits_; }

  bool contains(MaterialId m) const { return (bits_ >> m.value) & 1u; }
  bool empty() const { return bits_ == 0; }
  int size() const { return __builtin_popcountll(bits_); }
  /// The lowest id of a set that is not empty.
  MaterialId first() const { return MaterialId(__builtin_ctzll(bits_)); }
  /// How many members have a lower id than m.
  int rank(MaterialId m) const { return __builtin_popcountll(bits_ & ((std::uint64_t{ 1 } << m.value) - 1)); }
  void insert(MaterialId m) { bits_ |= std::uint64_t{ 1 } << m.value; }
  void erase(MaterialId m) { bits_ &= ~(std::uint64_t{ 1 } << m.value); }
  bool includes(MaterialSet other) const { return (other.bits_ & ~bits_) == 0; }

  friend MaterialSet operator|(MaterialSet a, MaterialSet b) { return MaterialSet(a.bits_ | b.bits_); }
  friend MaterialSet operator&(MaterialSet a, MaterialSet b) { return MaterialSet(a.bits_ & b.bits_); }
  friend MaterialSet operator-(MaterialSet a, MaterialSet b) { return MaterialSet(a.bits_ & ~b.bits_); }
  friend bool operator==(MaterialSet a, MaterialSet b) { return a.bits_ == b.bits_; }
  friend bool operator!=(MaterialSet a, MaterialSet b) { return a.bits_ != b.bits_; }

  /// Iterates over the ids in ascending order.
  class Iterator
  {
  public:
    explicit Iterator(std::uint64_t bits) : rest_(bits) {}
    MaterialId operator*() const { return MaterialId(__builtin_ctzll(rest_)); }
    Iterator& operator++()
    {
      rest_ &= rest_ - 1;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return rest_ != other.rest_; }

  private:
    std::uint64_t rest_;
  };
  Iterator begin() const { return Iterator(bits_); }
  Iterator end() const { return Iterator(0); }

private:
  constexpr explicit MaterialSet(std::uint64_t bits) : bits_(bits) {}
  std::uint64_t bits_ = 0;
};
}
