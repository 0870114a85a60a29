#pragma once

#include "Geometry/Box.h"

#include <algorithm>
#include <vector>

namespace strata
{
/// Points by place: a balanced k-d tree without nodes of its own.
class PointTree
{
public:
  explicit PointTree(std::vector<Vector> points) : points_(std::move(points)), order_(points_.size())
  {
    for (std::size_t i = 0; i < order_.size(); ++i)
    {
      order_[i] = i;
    }
    build(0, order_.size(), 0);
  }

  /// Calls visit(i) for the points within a box, in no particular order.
  template<typename Visit>
  void forEachIn(const Box& box, const Visit& visit) const
  {
    search(box, 0, order_.size(), 0, visit);
  }

private:
  void build(std::size_t begin, std::size_t end, int axis)
  {
    if (end - begin < 2)
    {
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const auto first = order_.begin();
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(middle),
      first + static_cast<std::ptrdiff_t>(end),
      [&](std::size_t a, std::size_t b) { return points_[a][axis] < points_[b][axis]; });
    build(begin, middle, (axis + 1) % 3);
    build(middle + 1, end, (axis + 1) % 3);
  }

  template<typename Visit>
  void search(const Box& box, std::size_t begin, std::size_t end, int axis, const Visit& visit) const
  {
    if (begin == end)
    {
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const Vector& point = points_[order_[middle]];
    if ((point.array() >= box.lower.array()).all() && (point.array() <= box.upper.array()).all())
    {
      visit(order_[middle]);
    }
    if (box.lower[axis] <= point[axis])
    {
      search(box, begin, middle, (axis + 1) % 3, visit);
    }
    if (box.upper[axis] >= point[axis])
    {
      search(box, middle + 1, end, (axis + 1) % 3, visit);
    }
  }

  std::vector<Vector> points_;
  std::vector<std::size_t> order_;
};
}
