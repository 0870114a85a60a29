#include "Native/LinearFit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cassert>

namespace strata
{
namespace
{
/// Smallest spread of the samples, relative to the largest, in a direction that gets a gradient; squared,
/// since a covariance holds squares.
constexpr double smallestSpread = 1e-3 * 1e-3;
/// Samples that spread less than this part of their distance from the origin, squared, are one: rounding.
constexpr double rounding = 1e-12 * 1e-12;
/// A determinant above this part of the cubed trace excludes small eigenvalues without finding them.
constexpr double safeDeterminant = 1e-5;
}

LinearFit::LinearFit(const FitSamples& samples)
{
  assert(samples.count > 0);
  mean_.setZero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i)
  {
    weightSum_ += samples.weights[i];
    mean_ += samples.weights[i] * samples.offsets[i];
  }
  mean_ /= weightSum_;

  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double size2 = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i)
  {
    size2 += samples.weights[i] * samples.offsets[i].squaredNorm();
    const Vector d = samples.offsets[i] - mean_;
    covariance.noalias() += (samples.weights[i] * d) * d.transpose();
  }
  const double trace = covariance.trace();
  if (trace <= rounding * size2)
  {
    inverse_.setZero();
    rank_ = 0;
    return;
  }
  if (covariance.determinant() > safeDeterminant * trace * trace * trace)
  {
    inverse_ = covariance.inverse();
    return;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const double largest = solver.eigenvalues()[2];
  inverse_.setZero();
  rank_ = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double eigenvalue = solver.eigenvalues()[axis];
    if (eigenvalue > 0.0 && eigenvalue >= smallestSpread * largest)
    {
      const Vector direction = solver.eigenvectors().col(axis);
      inverse_ += direction * direction.transpose() / eigenvalue;
      ++rank_;
    }
  }
}

void LinearFit::coefficients(const FitSamples& samples, const Vector& target, double* result) const
{
  const Vector slope = inverse_ * (target - mean_);
  for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i)
  {
    result[i] = samples.weights[i] * (1.0 / weightSum_ + slope.dot(samples.offsets[i] - mean_));
  }
}
}
