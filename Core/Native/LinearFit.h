#pragma once

#include "Geometry/Vector.h"
#include "Model/NativeData.h"

#include <array>

namespace strata
{
/// Samples of one material near a point, with weights: what a linear function is fitted to. Offsets are
/// relative to any origin and in any unit per axis, as long as it is the same for all.
struct FitSamples
{
  static constexpr int capacity = 343; // 7^3

  int count = 0;
  std::array<SampleIndex, capacity> samples;
  std::array<Vector, capacity> offsets;
  std::array<double, capacity> weights;

  void add(SampleIndex sample, const Vector& offset, double weight)
  {
    const auto i = static_cast<std::size_t>(count++);
    samples[i] = sample;
    offsets[i] = offset;
    weights[i] = weight;
  }
};

/// The weighted least-squares fit of a + g . offset to values at samples, whatever the values are: its value
/// at a target is a linear combination of them. Directions in which the samples hardly spread (singular
/// value below a thousandth of the largest) get no gradient; with one sample the fit is constant.
class LinearFit
{
public:
  /// At least one sample is needed.
  explicit LinearFit(const FitSamples& samples);

  /// Number of directions in which the fit has a gradient, 0 to 3.
  int rank() const { return rank_; }
  /// The factors of the samples' values in the fit's value at a target (an offset like the samples').
  void coefficients(const FitSamples& samples, const Vector& target, double* result) const;

private:
  Vector mean_;
  Eigen::Matrix3d inverse_; ///< of the weighted covariance, within the directions that count
  double weightSum_ = 0.0;
  int rank_ = 3;
};
}
