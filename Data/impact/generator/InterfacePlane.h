#pragma once

#include <array>

namespace impact
{
/// The part of the unit cube with normal . x <= offset, for a normal without negative components.
double cubeVolume(double offset, std::array<double, 3> normal);

/// A plane that cuts a cell such that the material behind it fills a given fraction of the cell.
class InterfacePlane
{
public:
  /// `outward` points out of the material, in units of cells.
  InterfacePlane(const std::array<double, 3>& outward, double fraction);

  /// The material's volume in the slab from <= x_axis <= to, in fractions of the cell.
  double slabVolume(int axis, double from, double to) const;

private:
  std::array<double, 3> normal_;
  std::array<bool, 3> flipped_;
  double offset_ = 0;
};
}
