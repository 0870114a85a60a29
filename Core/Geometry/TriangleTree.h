#pragma once

#include "Geometry/Box.h"
#include "Geometry/ClosestPoint.h"

#include <array>
#include <limits>
#include <vector>

namespace strata
{
/// A bounding volume hierarchy over triangles that answers closest-point queries. Queries are thread-safe.
class TriangleTree
{
public:
  struct Hit
  {
    std::int32_t triangle = -1; ///< position in the constructor's list; -1 if nothing is near enough
    Vector point = Vector::Zero();
    TriangleFeature feature = TriangleFeature::Face;
    double squaredDistance = std::numeric_limits<double>::infinity();
  };

  explicit TriangleTree(std::vector<std::array<Vector, 3>> triangles);

  bool empty() const { return triangles_.empty(); }
  const std::vector<std::array<Vector, 3>>& triangles() const { return triangles_; }

  /// The closest point of all triangles, if it is not farther than the given distance. Among equally close
  /// triangles the first of the list wins.
  Hit closest(const Vector& p, double maximumSquaredDistance = std::numeric_limits<double>::infinity()) const;

private:
  /// Inner nodes have their first child right behind them and `second` as the other; leaves have count > 0.
  struct Node
  {
    Box box;
    std::int32_t second = 0;
    std::int32_t first = 0;
    std::int32_t count = 0;
  };

  void build(std::int32_t id, std::int32_t begin, std::int32_t end, const std::vector<Vector>& centers);
  void searchLeaf(const Node& node, const Vector& p, Hit& best) const;

  std::vector<std::array<Vector, 3>> triangles_;
  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;
};
}
