#pragma once

#include "Geometry/Vector.h"
#include "Model/Simulation.h"

#include <array>
#include <vector>

namespace strata
{
/// The sample positions of one association on a rectilinear grid: products of three ascending lists.
struct SampleLattice
{
  using Position = std::array<Index, 3>;

  std::array<std::vector<double>, 3> coordinates;

  Index count(int axis) const { return static_cast<Index>(coordinates[static_cast<std::size_t>(axis)].size()); }
  double coordinate(int axis, Index i) const
  {
    return coordinates[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
  }
  Index index(const Position& p) const { return p[0] + count(0) * (p[1] + count(1) * p[2]); }
  Position position(Index sample) const
  {
    const Index row = sample / count(0);
    return { sample % count(0), row % count(1), row / count(1) };
  }
  Vector point(const Position& p) const { return { coordinate(0, p[0]), coordinate(1, p[1]), coordinate(2, p[2]) }; }
};

/// Visits the positions of a block, both corners included, the first axis fastest.
template<typename Visit>
void forEachPosition(const SampleLattice::Position& first, const SampleLattice::Position& last, const Visit& visit)
{
  for (Index k = first[2]; k <= last[2]; ++k)
  {
    for (Index j = first[1]; j <= last[1]; ++j)
    {
      for (Index i = first[0]; i <= last[0]; ++i)
      {
        visit(SampleLattice::Position{ i, j, k });
      }
    }
  }
}

/// The samples of a rectilinear grid: its cell centres or its points.
SampleLattice latticeOf(const RectilinearGrid& grid, Association association);

/// A coordinate between two neighbours of a lattice's list: at lower + fraction (upper - lower). Beyond the ends
/// of the list the fraction is negative or above 1.
struct Interval
{
  Index lower = 0;
  double fraction = 0.0;
};

/// The interval of a list in which x lies; beyond its ends, the first or last one.
Interval intervalAt(const std::vector<double>& coordinates, double x);

/// The lattice position nearest to a point along each axis.
SampleLattice::Position nearestPosition(const SampleLattice& lattice, const Vector& point);

/// Distance between samples at a position, along each axis.
Vector spacingAt(const SampleLattice& lattice, const SampleLattice::Position& position);

/// The corners of the lattice cell round a point, with the weights of multilinear interpolation. Corners of
/// weight 0 are left out, so that a sample's own position needs no other sample.
class LatticeCorners
{
public:
  struct Corner
  {
    SampleLattice::Position position{};
    double weight = 0.0;
  };

  /// Beyond the lattice the weights extrapolate from its two outermost layers, unless they are clamped to it.
  LatticeCorners(const SampleLattice& lattice, const Vector& point, bool clamped);

  const Corner* begin() const { return corners_.data(); }
  const Corner* end() const { return corners_.data() + count_; }

private:
  void add(const std::array<Interval, 3>& intervals, int corner);

  std::array<Corner, 8> corners_;
  int count_ = 0;
};
}
