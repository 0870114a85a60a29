#pragma once

#include "Geometry/CutPoint.h"

#include <array>
#include <cstdint>

namespace strata
{
/// Linear functions on a simplex of up to four corners, and exact questions about the points where they tie.
///
/// A point is named by the corners that span it (bits) and the functions that tie in it (bits of their ids).
/// Optionally all points lie in a plane as well, the zero set of one more linear function.
/// Ties are broken symbolically: function m counts as lowered by e^(m+1) with an infinitesimal e > 0, and the
/// plane's function as raised by an even larger infinitesimal, so its zeros count as positive.
/// Then n + 1 functions never tie on n corners, and every sign below is +1 or -1.
class FunctionTies
{
public:
  /// Starts over with corners given by ascending global ids.
  void reset(const std::array<std::int64_t, 4>& vertices);
  /// Adds a function with its id, 0 to 63, and its values at the corners.
  void add(int function, const std::array<double, 4>& values);
  /// Restricts all points to the zeros of a function.
  void setPlane(const std::array<double, 4>& values);

  const std::array<std::int64_t, 4>& vertices() const { return vertices_; }
  double value(int function, int corner) const { return values_[function][corner]; }
  bool hasPlane() const { return hasPlane_; }

  /// True if `other` is smaller than `function` at each of the given corners.
  bool dominates(int other, int function, unsigned corners) const;
  /// The sign of (candidate - tied functions) at the point. `tied` doesn't contain the candidate.
  int sign(unsigned corners, std::uint64_t tied, int candidate) const;
  /// The point by its canonical name: carried by the fewest vertices, whatever corners span it.
  /// `candidates` are the functions that may win somewhere. `coordinates` receives its barycentric coordinates.
  CutPoint point(
    unsigned corners, std::uint64_t tied, std::uint64_t candidates, std::array<double, 4>& coordinates) const;

private:
  /// Row of a function (its values, 1), of the plane (its values, 0) or of the constant one (1 ... 1, 0).
  struct Row;
  struct System;

  System system(unsigned corners, std::uint64_t tied, bool inPlane) const;
  int perturbedSign(const System& system, int candidate) const;
  int signIn(bool inPlane, unsigned corners, std::uint64_t tied, int candidate) const;
  bool ties(unsigned corners, std::uint64_t tied, int candidate) const;
  void edgeWeights(bool inPlane, unsigned corners, std::uint64_t tied, std::array<double, 4>& result) const;
  void weights(bool inPlane, unsigned corners, std::uint64_t tied, std::array<double, 4>& result) const;
  std::uint64_t canonicalTie(bool inPlane, unsigned corners, std::uint64_t tied, int size) const;

  std::array<std::int64_t, 4> vertices_{};
  std::array<std::array<double, 4>, 64> values_{};
  std::array<double, 4> plane_{};
  bool hasPlane_ = false;
};
}
