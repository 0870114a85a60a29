#pragma once

#include "Conversion/CurvedCells.h"

#include <cstddef>
#include <vector>

namespace strata::conversion
{
/// Bounds how far a place or a field in curved cells may lie from that in their linear pieces. The difference is a
/// polynomial in each piece: it is nowhere longer than the longest of its coefficients in Bernstein's form, and halving
/// the piece brings them closer to its values (de Casteljau).
class CurvedDeviation
{
public:
  explicit CurvedDeviation(int components) : components_(static_cast<std::size_t>(components)) {}

  /// Adds a cell by the values at its nodes, the components of each together.
  void add(const CurvedPattern& pattern, const std::vector<double>& nodeValues);

  /// An upper bound of the length of the difference in all cells added: no more than a tenth above the largest, or
  /// above rounding, unless that took more bisections than are made.
  double bound() const { return bound_ + slack_; }

private:
  /// A part of a piece, with the longest of its coefficients.
  struct Part
  {
    std::vector<double> coefficients;
    double bound;
    int axis; ///< to halve next
  };

  /// Lengths up to `tooSmall` are not looked into.
  void addPiece(int degree, const std::vector<double>& coefficients, double tooSmall);
  double longest(const std::vector<double>& coefficients, std::size_t count) const;
  double longestAtCorners(int degree, const std::vector<double>& coefficients) const;
  Part half(const Part& whole, int degree, bool upper) const;
  /// Puts a part aside, for good where its bound is close enough to what is reached.
  void consider(Part&& part, int degree, double tooSmall, std::vector<Part>& open);

  std::size_t components_;
  double reached_ = 0.0; ///< by a value
  double bound_ = 0.0;
  double slack_ = 0.0; ///< rounding of the coefficients
};
}
