#pragma once

#include "Geometry/Vector.h"
#include "Model/Interfaces.h"
#include "Model/Progress.h"

#include <unordered_map>
#include <vector>

namespace strata
{
/// The interface triangles of a block of cells. Points are named by their position: two makers of the same point
/// must compute it bit by bit alike, and points that coincide exactly are one.
class SurfacePatch
{
public:
  struct Triangle
  {
    std::uint8_t positive; ///< lower than negative
    std::uint8_t negative;
    std::array<std::int32_t, 3> corners;
  };

  /// The point's number within the patch.
  std::int32_t addPoint(const Vector& position);
  /// A triangle whose counter-clockwise normal points into `front`, away from `back`. Does nothing if two corners
  /// are the same.
  void addTriangle(std::uint8_t front, std::uint8_t back, const std::array<std::int32_t, 3>& corners);

  const std::vector<Vector>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

private:
  struct Hash
  {
    std::size_t operator()(const Vector& position) const;
  };

  std::vector<Vector> points_;
  std::vector<Triangle> triangles_;
  std::unordered_map<Vector, std::int32_t, Hash> numbers_;
};

/// Joins patches into surfaces that share their points. Pairs of triangles that cancel each other (same corners,
/// opposite sides) and repetitions are left out.
Interfaces joinPatches(const std::vector<SurfacePatch>& patches, Progress& progress);
}
