#pragma once

#include "Geometry/Vector.h"

#include <vector>

namespace strata
{
/// What one value at a vertex does to the errors of the cells round it.
///
/// The objective is the sum over groups of rows of (largest error / bound)^8: nearly the largest of all, but, unlike
/// that, it still falls when a value helps one cell that is not the worst, so that vertices do not block each
/// other. It is convex in a field's value, and nearly so in a distance.
class Influence
{
public:
  void clear()
  {
    residuals_.clear();
    weights_.clear();
    others_.clear();
    groups_.clear();
  }

  /// Rows of a field's component; `others` is the squared difference of the other components.
  void beginGroup(double bound)
  {
    groups_.push_back({ residuals_.size(), residuals_.size(), 1.0 / bound, false, Vector::Zero(), Vector::Zero() });
  }
  /// Rows of an interface: the plane's gradient is `gradient` + change * `slope`.
  void beginGroup(double bound, const Vector& gradient, const Vector& slope)
  {
    groups_.push_back({ residuals_.size(), residuals_.size(), 1.0 / bound, true, gradient, slope });
  }
  void add(double residual, double weight, double others)
  {
    residuals_.push_back(residual);
    weights_.push_back(weight);
    others_.push_back(others);
    groups_.back().end = residuals_.size();
  }

  /// The largest relative error after a change of the value.
  double largest(double change) const;
  double objective(double change) const;
  /// The change within [-reach, reach] with the smallest objective that a golden-section search finds.
  double bestChange(double reach) const;

private:
  struct Group
  {
    std::size_t begin;
    std::size_t end;
    double inverseBound;
    bool isPlane;
    Vector gradient;
    Vector slope;
  };

  double error(const Group& group, double change) const;

  std::vector<double> residuals_;
  std::vector<double> weights_;
  std::vector<double> others_;
  std::vector<Group> groups_;
};
}
