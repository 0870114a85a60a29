#pragma once

#include "Geometry/CutPoint.h"
#include "Geometry/FunctionTies.h"

#include <array>
#include <cstdint>
#include <vector>

namespace strata
{
/// A linear function on a tetrahedron: its id, 0 to 63, and its values at the corners, in their order.
/// Values are finite, below 1e60 in size; below 1e-60 they count as 0.
struct CornerValues
{
  int function = 0;
  std::array<double, 4> values{};
};

/// A vertex of a region of one function m, named by what it lies on: the corners that span it (bits), and the
/// functions other than m that tie with m there (bits). Spanned by n corners, it ties with n - 1 others, or one
/// less within a plane.
struct SymbolicVertex
{
  std::uint8_t corners = 0;
  std::uint64_t others = 0;

  /// The vertex where the edge from a to b meets the region of one more function.
  static SymbolicVertex between(const SymbolicVertex& a, const SymbolicVertex& b, int function)
  {
    return { static_cast<std::uint8_t>(a.corners | b.corners), (a.others & b.others) | std::uint64_t{ 1 } << function };
  }
};

/// What the cuts of tetrahedra and of polygons have in common: corners, competing functions, and points made once.
class CutPoints
{
public:
  /// Starts over. `vertices` are global ids, all different; only the given `corners` (bits) take part.
  void reset(const std::array<std::int64_t, 4>& vertices, unsigned corners = 15u);
  /// Sets the competing functions, with ascending ids; those that another one beats at every corner drop out.
  void setFunctions(const CornerValues* functions, int count);
  /// Restricts the cut to the zeros of a function, given at the corners.
  void setPlane(const std::array<double, 4>& values);

  /// The functions that may win somewhere, ascending.
  const std::vector<int>& candidates() const { return candidates_; }
  /// The sign of (other - function) at each of the vertices of the function's region.
  void signs(const std::vector<SymbolicVertex>& vertices, int function, int other, std::vector<int>& result) const;
  /// The number of a point, which is made if it is new.
  int pointOf(const SymbolicVertex& vertex, int function);
  /// Appends a region's loop, given as points; without repeated points, and not at all if it collapses.
  /// Turns it round where the corners' order did. Returns whether anything is left.
  bool appendLoop(const std::vector<int>& loop, std::vector<int>& loops) const;

  const std::vector<CutPoint>& points() const { return points_; }
  const std::vector<std::array<double, 4>>& coordinates() const { return coordinates_; }
  const std::array<std::int64_t, 4>& sortedVertices() const { return ties_.vertices(); }
  /// Position among the given corners of the corner with the i-th lowest id.
  int givenCorner(int i) const { return order_[i]; }
  bool reversed() const { return reversed_; }

private:
  struct NamedPoint
  {
    std::uint8_t corners;
    std::uint64_t tied;
    int point;
  };

  std::array<double, 4> sorted(const std::array<double, 4>& values) const
  {
    return { values[order_[0]], values[order_[1]], values[order_[2]], values[order_[3]] };
  }

  FunctionTies ties_;
  unsigned corners_ = 15u;
  std::array<int, 4> order_{};
  bool reversed_ = false;
  std::vector<int> candidates_;
  std::uint64_t candidateBits_ = 0;
  std::vector<CutPoint> points_;
  std::vector<std::array<double, 4>> coordinates_;
  std::vector<NamedPoint> named_;
};
}
