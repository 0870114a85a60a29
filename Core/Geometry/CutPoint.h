#pragma once

#include "Geometry/Vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace strata
{
/// The name of a point of a cut: the vertices that carry it and the functions that tie in it. Whatever
/// tetrahedron makes the point, the name is the same, and different points have different names.
struct CutKey
{
  /// Global ids, ascending, padded with -1: 1 at a vertex, 2 on an edge, 3 on a face, 4 inside.
  std::array<std::int64_t, 4> vertices{ -1, -1, -1, -1 };
  /// The ids of the functions that tie, one bit each; as many as vertices, none at a vertex.
  std::uint64_t functions = 0;

  friend bool operator==(const CutKey& a, const CutKey& b)
  {
    return a.vertices == b.vertices && a.functions == b.functions;
  }
  friend bool operator!=(const CutKey& a, const CutKey& b) { return !(a == b); }
  friend bool operator<(const CutKey& a, const CutKey& b)
  {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.functions < b.functions;
  }
};

/// Hash for unordered containers.
struct CutKeyHash
{
  std::size_t operator()(const CutKey& key) const
  {
    std::uint64_t hash = key.functions * 0x9E3779B97F4A7C15ull;
    for (std::int64_t vertex : key.vertices)
    {
      hash = (hash ^ static_cast<std::uint64_t>(vertex)) * 0xBF58476D1CE4E5B9ull;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// A point of a cut. Its weights belong to its key's vertices in their order; they are positive and sum to 1,
/// and are bitwise the same from every tetrahedron round the point.
struct CutPoint
{
  CutKey key;
  std::array<double, 4> weights{ 1.0, 0.0, 0.0, 0.0 };

  /// Number of vertices that carry the point.
  int carriers() const
  {
    int count = 1;
    while (count < 4 && key.vertices[count] >= 0)
    {
      ++count;
    }
    return count;
  }

  /// Interpolates a quantity given as a function of the vertex id. What is equal at all carriers stays exactly so:
  /// points of a face in a coordinate plane lie in that plane.
  template<typename ValueOfVertex>
  auto interpolate(const ValueOfVertex& valueOf) const
  {
    using Value = std::decay_t<decltype(valueOf(key.vertices[0]))>;
    const Value first = valueOf(key.vertices[0]);
    Value sum = first;
    for (int i = 1; i < 4 && key.vertices[i] >= 0; ++i)
    {
      sum += weights[i] * (valueOf(key.vertices[i]) - first);
    }
    return sum;
  }
};
}
