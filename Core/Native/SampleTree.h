#pragma once

#include "Geometry/Vector.h"
#include "Model/Ids.h"
#include "Model/Progress.h"

#include <array>
#include <cstdint>
#include <vector>

namespace strata
{
/// A sample and its squared distance from the point of a query; ordered by distance, then by index.
struct Neighbor
{
  double squaredDistance = 0.0;
  std::uint32_t sample = 0;

  friend bool operator<(const Neighbor& a, const Neighbor& b)
  {
    return a.squaredDistance != b.squaredDistance ? a.squaredDistance < b.squaredDistance : a.sample < b.sample;
  }
};

/// The nearest neighbours found so far, nearest first.
struct Neighbors
{
  static constexpr int capacity = 64;

  explicit Neighbors(int wantedCount) : wanted(wantedCount) {}
  const Neighbor& operator[](int i) const { return found[static_cast<std::size_t>(i)]; }
  const Neighbor& farthest() const { return found[static_cast<std::size_t>(count) - 1]; }
  bool full() const { return count == wanted; }
  void add(const Neighbor& neighbor);

  int wanted;
  int count = 0;
  std::array<Neighbor, capacity> found;
};

/// A k-d tree over some of the points of a list, which stays elsewhere: 4 bytes a sample and 2 a node's share.
class SampleTree
{
public:
  SampleTree() = default;
  /// A tree over points[sample] for the given samples.
  SampleTree(const std::vector<Vector>& points, std::vector<std::uint32_t> samples, Progress& progress);

  Index size() const { return static_cast<Index>(samples_.size()); }
  /// Fills `neighbors` with the samples nearest to a point, ties by the lower index; fewer if there are not so many.
  void nearest(const std::vector<Vector>& points, const Vector& point, Neighbors& neighbors) const;

private:
  /// Samples of a node's first child have a coordinate of at most `split`, those of the second at least that.
  struct Node
  {
    double split = 0.0;
    std::int32_t axis = 0;
  };
  /// A node and its samples; its children are the nodes 2 node + 1 and 2 node + 2.
  struct Part
  {
    std::size_t node = 0;
    std::size_t begin = 0;
    std::size_t end = 0;

    std::size_t middle() const { return begin + (end - begin) / 2; }
    Part lower() const { return { 2 * node + 1, begin, middle() }; }
    Part upper() const { return { 2 * node + 2, middle(), end }; }
  };

  void build(const std::vector<Vector>& points, const Part& part, Progress& progress);
  void search(const std::vector<Vector>& points, const Vector& point, const Part& part, Neighbors& neighbors) const;

  std::vector<std::uint32_t> samples_;
  std::vector<Node> nodes_;
};
}
