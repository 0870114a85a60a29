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
  /// Boxes of up to four children side by side, [axis][child], for the processor to deal with together. A child is a
  /// node or, as the complement of its number, a triangle.
  struct Node
  {
    std::array<Eigen::Array4d, 3> lower;
    std::array<Eigen::Array4d, 3> upper;
    std::array<std::int32_t, 4> child{};
    std::int32_t count = 0;

    void add(std::int32_t newChild, const Box& box);
    /// From a point to the boxes; 0 inside.
    Eigen::Array4d squaredDistances(const Vector& p) const;
  };

  /// Part of the triangles in the order of the tree.
  struct Range
  {
    std::int32_t begin = 0;
    std::int32_t end = 0;

    std::int32_t count() const { return end - begin; }
  };

  Box buildLeaf(Node& node, Range range);
  Box build(std::int32_t id, Range range, const std::vector<Vector>& centers);
  std::array<Range, 2> halves(Range range, const std::vector<Vector>& centers);
  void test(std::int32_t triangle, const Vector& p, Hit& best) const;

  std::vector<std::array<Vector, 3>> triangles_;
  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;
};
}
