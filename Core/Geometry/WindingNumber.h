#pragma once

#include "Geometry/Box.h"

#include <array>
#include <cstdint>
#include <vector>

namespace strata
{
/// Generalized winding numbers of triangles (Jacobson, Kavan and Sorkine-Hornung 2013): the part of the directions from
/// a point that meets them from behind less the part that meets them from the front. For a closed surface with its
/// normals outwards 1 inside, 0 outside; where the surface has holes or doubled triangles it goes smoothly over from
/// one to the other. Triangles far away count as one dipole for many (Barill et al. 2018). Queries are thread-safe.
class WindingNumber
{
public:
  /// Cost: n log n.
  explicit WindingNumber(std::vector<std::array<Vector, 3>> triangles);

  /// Within about 0.02 of the sum over all triangles. Cost: log n.
  double at(const Vector& point) const;

  /// How often the way from one point to another leads through triangles along their normals, less how often against.
  int crossings(const Vector& from, const Vector& to) const;

private:
  /// Inner nodes have their first child right behind them and `second` as the other; leaves have count > 0.
  struct Node
  {
    Vector center = Vector::Zero(); ///< of area
    Vector normal = Vector::Zero(); ///< sum of the area vectors
    double radius = 0.0;            ///< of a ball round the center that holds the triangles
    std::int32_t second = 0;
    std::int32_t first = 0;
    std::int32_t count = 0;
  };

  std::int32_t build(std::int32_t begin, std::int32_t end);
  Node summary(std::int32_t begin, std::int32_t end) const;
  double angleFrom(std::int32_t node, const Vector& point) const;
  int crossingsOf(std::int32_t node, const Vector& from, const Vector& way) const;

  std::vector<std::array<Vector, 3>> triangles_;
  std::vector<Node> nodes_;
};
}
