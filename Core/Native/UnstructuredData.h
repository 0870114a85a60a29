#pragma once

#include "Native/SampleTree.h"
#include "Native/SampledData.h"

namespace strata
{
/// How a linear function is fitted: to how many of the nearest samples (twice as many, up to what Neighbors
/// can hold, where they don't spread in all directions), and how a sample weighs by its squared distance
/// relative to that of the farthest.
struct FitRule
{
  int size;
  double (*weight)(double relativeSquaredDistance);
};

/// Native data on an unstructured grid: linear fits to a material's samples near a point. Cell samples lie
/// at the cells' centres of volume.
class UnstructuredData final : public SampledData
{
public:
  UnstructuredData(const Simulation& simulation, const NativeOptions& options, Progress& progress);

  void positions(const SampleIndex* samples, Index count, Vector* result) const override;
  void evaluate(MaterialId m, const Vector& point, bool inside, const Vector& closest, GhostMethod method,
    double* result) const override;

private:
  /// One group's sample positions, and a tree over the samples of each material.
  struct Cloud
  {
    std::vector<Vector> points;
    std::vector<SampleTree> trees;
  };

  bool sampleNear(std::size_t group, MaterialId m, const Vector& point) const;
  /// The linear fit to m's samples nearest to a point, at the point. It takes each sample's own value at the
  /// sample's position.
  void interpolate(std::size_t group, MaterialId m, const Vector& point, double* result) const;
  /// The mean of m's samples nearest to a point, weighted by the inverse squared distance.
  void average(std::size_t group, MaterialId m, const Vector& point, double* result) const;
  /// Linear extrapolation from m's samples near `closest`.
  void extrapolate(std::size_t group, MaterialId m, const Vector& point, const Vector& closest, double* result) const;
  /// Adds the linear fit to m's samples nearest to `origin`, at `point`.
  void addFitRound(std::size_t group, MaterialId m, const Vector& origin, const Vector& point, const FitRule& rule,
    double* result) const;

  std::vector<Cloud> clouds_;
};
}
