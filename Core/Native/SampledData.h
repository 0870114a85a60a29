#pragma once

#include "Model/Simulation.h"
#include "Native/FieldRanges.h"
#include "Native/LinearFit.h"
#include "Native/ReadNativeData.h"
#include "Native/SampleMaterials.h"

#include <vector>

namespace strata
{
/// The samples of one association, and which fields are known there.
struct SampleGroup
{
  Association association = Association::Cells;
  SampleIndex first = 0; ///< index of the group's first sample among all samples
  SampleMaterials materials;
  std::vector<FieldId> fields;
};

/// What native data on any grid share: samples in groups, cell samples first, and their values.
class SampledData : public NativeData
{
public:
  SampledData(const Simulation& simulation, const NativeOptions& options, Progress& progress);

  SampleIndex sampleCount() const override { return sampleCount_; }
  void materialsAt(const SampleIndex* samples, Index count, MaterialSet* result) const override;
  void values(FieldId field, MaterialId m, const SampleIndex* samples, Index count, double* result) const override;

protected:
  const std::vector<SampleGroup>& groups() const { return groups_; }
  const SampleGroup& groupOf(SampleIndex sample) const { return groups_[groupIndex(sample)]; }
  std::size_t groupIndex(SampleIndex sample) const { return groups_.size() > 1 && sample >= groups_[1].first ? 1 : 0; }

  /// Makes the group's fields in `result` (as long as evaluate's) NaN, before a combination is added.
  void setUnknown(const SampleGroup& group, double* result) const;
  /// Makes them 0 where the material has them, NaN elsewhere.
  void setZero(const SampleGroup& group, MaterialId m, double* result) const;
  /// Adds `factor` times the values at one of the group's samples.
  void addSample(const SampleGroup& group, MaterialId m, SampleIndex sample, double factor, double* result) const;
  /// Adds `factor` times the value of the fit at the target. The value stays within the range of the fitted samples
  /// plus or minus one range of the material's field, unless the samples lie on the fit exactly.
  void addFit(const SampleGroup& group, MaterialId m, const FitSamples& samples, const LinearFit& fit,
    const Vector& target, double factor, double* result) const;

private:
  void addGroup(
    const Simulation& simulation, Association association, const NativeOptions& options, Progress& progress);
  void readRanges(Progress& progress);

  std::vector<SimulationField> arrays_;
  std::vector<SampleGroup> groups_;
  std::vector<FieldRange> fieldRanges_;
  std::vector<int> firstComponent_; ///< of each field, in evaluate's result
  SampleIndex sampleCount_ = 0;
};
}
