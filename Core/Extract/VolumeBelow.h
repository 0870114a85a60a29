#pragma once

#include "Extract/CellComplex.h"

#include <array>
#include <vector>

namespace strata
{
/// The part of a cell of a complex that lies below parallel planes: normal . (x - centre) < offset.
class VolumeBelow
{
public:
  VolumeBelow(const CellComplex& complex, std::int32_t cell, const Vector& normal = Vector::UnitX());

  /// Volume of the cell.
  double total() const { return total_; }
  /// The offset below which a given fraction of the cell lies, 0 < fraction < 1.
  double offset(double fraction) const;

private:
  struct Tetrahedron
  {
    std::array<double, 4> heights; ///< of its corners, ascending
    double volume;
  };

  /// Volume below an offset, and its derivative.
  std::array<double, 2> evaluate(double offset) const;

  std::vector<Tetrahedron> tetrahedra_;
  double total_ = 0.0;
  double lowest_ = 0.0;
  double highest_ = 0.0;
};
}
