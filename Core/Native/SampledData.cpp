#include "Native/SampledData.h"

#include "Model/Errors.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
/// Samples lie on a fit if they miss it by no more than this part of the material's range.
constexpr double exactFit = 1e-9;

/// Whether the values of a component lie on the fit.
bool fitsExactly(const ValueArray& values, int component, SampleIndex first, const FitSamples& samples,
  const LinearFit& fit, double tolerance)
{
  std::array<double, FitSamples::capacity> coefficients;
  for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i)
  {
    fit.coefficients(samples, samples.offsets[i], coefficients.data());
    double value = 0.0;
    for (std::size_t j = 0; j < static_cast<std::size_t>(samples.count); ++j)
    {
      value += coefficients[j] * values(samples.samples[j] - first, component);
    }
    if (std::abs(value - values(samples.samples[i] - first, component)) > tolerance)
    {
      return false;
    }
  }
  return true;
}
}

SampledData::SampledData(const Simulation& simulation, const NativeOptions& options, Progress& progress) :
  arrays_(simulation.fields)
{
  box_ = bounds(simulation.grid);
  materials_ = simulation.materials;
  int components = 0;
  for (const SimulationField& field : arrays_)
  {
    fields_.push_back({ field.name, field.components });
    firstComponent_.push_back(components);
    components += field.components;
  }
  for (const Association association : { Association::Cells, Association::Points })
  {
    const bool used = std::any_of(
      arrays_.begin(), arrays_.end(), [&](const SimulationField& field) { return field.association == association; });
    // Without fields, cell samples still tell where the materials are.
    if (used || (arrays_.empty() && association == Association::Cells))
    {
      addGroup(simulation, association, options, progress);
    }
  }
  readRanges(progress);
}

void SampledData::addGroup(
  const Simulation& simulation, Association association, const NativeOptions& options, Progress& progress)
{
  SampleGroup group;
  group.association = association;
  group.first = sampleCount_;
  const Index count = association == Association::Cells ? cellCount(simulation.grid) : pointCount(simulation.grid);
  if (count + sampleCount_ > static_cast<Index>(std::numeric_limits<SampleIndex>::max()))
  {
    throw InvalidInput("the grid has " + std::to_string(count + sampleCount_) + " samples; at most " +
                       std::to_string(std::numeric_limits<SampleIndex>::max()) + " are possible");
  }
  group.materials = findSampleMaterials(simulation, association, options.minimumVolumeFraction, progress);
  sampleCount_ += static_cast<SampleIndex>(count);
  for (std::size_t f = 0; f < arrays_.size(); ++f)
  {
    if (arrays_[f].association == association)
    {
      group.fields.push_back(FieldId(static_cast<Index>(f)));
    }
  }
  groups_.push_back(std::move(group));
}

void SampledData::readRanges(Progress& progress)
{
  fieldRanges_.resize(arrays_.size());
  ranges_.resize(arrays_.size());
  magnitudes_.resize(arrays_.size());
  for (const SampleGroup& group : groups_)
  {
    for (const FieldId field : group.fields)
    {
      const auto f = static_cast<std::size_t>(field.value);
      fieldRanges_[f] = findRange(arrays_[f], materials_, group.materials, progress);
      ranges_[f] = fieldRanges_[f].length.size();
      magnitudes_[f] = fieldRanges_[f].length.magnitude();
    }
  }
}

void SampledData::materialsAt(const SampleIndex* samples, Index count, MaterialSet* result) const
{
  for (Index i = 0; i < count; ++i)
  {
    const SampleGroup& group = groupOf(samples[i]);
    result[i] = group.materials[samples[i] - group.first];
  }
}

void SampledData::values(FieldId field, MaterialId m, const SampleIndex* samples, Index count, double* result) const
{
  const SimulationField& arrays = arrays_[static_cast<std::size_t>(field.value)];
  const ValueArray& values = arrays.values[static_cast<std::size_t>(m.value)];
  for (Index i = 0; i < count; ++i)
  {
    const SampleGroup& group = groupOf(samples[i]);
    const bool known = values && group.association == arrays.association;
    for (int c = 0; c < arrays.components; ++c)
    {
      *result++ = known ? values(samples[i] - group.first, c) : unknown;
    }
  }
}

void SampledData::setUnknown(const SampleGroup& group, double* result) const
{
  for (const FieldId field : group.fields)
  {
    const auto f = static_cast<std::size_t>(field.value);
    std::fill_n(result + firstComponent_[f], arrays_[f].components, unknown);
  }
}

void SampledData::setZero(const SampleGroup& group, MaterialId m, double* result) const
{
  for (const FieldId field : group.fields)
  {
    const auto f = static_cast<std::size_t>(field.value);
    const bool known = static_cast<bool>(arrays_[f].values[static_cast<std::size_t>(m.value)]);
    std::fill_n(result + firstComponent_[f], arrays_[f].components, known ? 0.0 : unknown);
  }
}

void SampledData::addSample(
  const SampleGroup& group, MaterialId m, SampleIndex sample, double factor, double* result) const
{
  for (const FieldId field : group.fields)
  {
    const auto f = static_cast<std::size_t>(field.value);
    const ValueArray& values = arrays_[f].values[static_cast<std::size_t>(m.value)];
    for (int c = 0; values && c < arrays_[f].components; ++c)
    {
      result[firstComponent_[f] + c] += factor * values(sample - group.first, c);
    }
  }
}

void SampledData::addFit(const SampleGroup& group, MaterialId m, const FitSamples& samples, const LinearFit& fit,
  const Vector& target, double factor, double* result) const
{
  std::array<double, FitSamples::capacity> coefficients;
  fit.coefficients(samples, target, coefficients.data());
  for (const FieldId field : group.fields)
  {
    const auto f = static_cast<std::size_t>(field.value);
    const ValueArray& values = arrays_[f].values[static_cast<std::size_t>(m.value)];
    for (int c = 0; values && c < arrays_[f].components; ++c)
    {
      double value = 0.0;
      Range range;
      for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i)
      {
        const double sample = values(samples.samples[i] - group.first, c);
        value += coefficients[i] * sample;
        range.add(sample);
      }
      const double allowance =
        fieldRanges_[f].materials[static_cast<std::size_t>(m.value)][static_cast<std::size_t>(c)].size();
      const double limited = std::clamp(value, range.lower - allowance, range.upper + allowance);
      if (limited != value && !fitsExactly(values, c, group.first, samples, fit, exactFit * allowance))
      {
        value = limited;
      }
      result[firstComponent_[f] + c] += factor * value;
    }
  }
}
}
