#include "Native/SampleLattice.h"

#include <algorithm>

namespace strata
{
SampleLattice latticeOf(const RectilinearGrid& grid, Association association)
{
  SampleLattice result;
  result.coordinates = grid.coordinates;
  if (association == Association::Cells)
  {
    for (std::vector<double>& axis : result.coordinates)
    {
      for (std::size_t i = 0; i + 1 < axis.size(); ++i)
      {
        axis[i] = 0.5 * (axis[i] + axis[i + 1]);
      }
      axis.pop_back();
    }
  }
  return result;
}

Interval intervalAt(const std::vector<double>& coordinates, double x)
{
  const auto count = static_cast<Index>(coordinates.size());
  if (count == 1)
  {
    return {};
  }
  const Index upper = std::upper_bound(coordinates.begin(), coordinates.end(), x) - coordinates.begin();
  const Index lower = std::clamp<Index>(upper - 1, 0, count - 2);
  const double start = coordinates[static_cast<std::size_t>(lower)];
  return { lower, (x - start) / (coordinates[static_cast<std::size_t>(lower) + 1] - start) };
}

SampleLattice::Position nearestPosition(const SampleLattice& lattice, const Vector& point)
{
  SampleLattice::Position result{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Interval interval = intervalAt(lattice.coordinates[axis], point[static_cast<Index>(axis)]);
    result[axis] = interval.lower + (interval.fraction > 0.5 ? 1 : 0);
  }
  return result;
}

Vector spacingAt(const SampleLattice& lattice, const SampleLattice::Position& position)
{
  Vector result = Vector::Ones();
  for (int axis = 0; axis < 3; ++axis)
  {
    const Index lower = std::max<Index>(position[static_cast<std::size_t>(axis)] - 1, 0);
    const Index upper = std::min<Index>(position[static_cast<std::size_t>(axis)] + 1, lattice.count(axis) - 1);
    if (upper > lower)
    {
      result[axis] =
        (lattice.coordinate(axis, upper) - lattice.coordinate(axis, lower)) / static_cast<double>(upper - lower);
    }
  }
  return result;
}

LatticeCorners::LatticeCorners(const SampleLattice& lattice, const Vector& point, bool clamped)
{
  std::array<Interval, 3> intervals;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    intervals[axis] = intervalAt(lattice.coordinates[axis], point[static_cast<Index>(axis)]);
    if (clamped)
    {
      intervals[axis].fraction = std::clamp(intervals[axis].fraction, 0.0, 1.0);
    }
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    add(intervals, corner);
  }
}

void LatticeCorners::add(const std::array<Interval, 3>& intervals, int corner)
{
  Corner result{ {}, 1.0 };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const bool upper = ((corner >> axis) & 1) != 0;
    result.position[axis] = intervals[axis].lower + (upper ? 1 : 0);
    result.weight *= upper ? intervals[axis].fraction : 1.0 - intervals[axis].fraction;
  }
  if (result.weight != 0.0)
  {
    corners_[static_cast<std::size_t>(count_++)] = result;
  }
}
}
