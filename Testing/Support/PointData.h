#pragma once

#include "Model/NativeData.h"

#include <cmath>
#include <functional>
#include <limits>

namespace strata::test
{
/// Native data made by hand: samples at given points, each counting for given materials, with fields that are functions
/// of the position. `evaluate` answers with the functions wherever it is asked.
class PointData : public NativeData
{
public:
  using Function = std::function<double(MaterialId, const Vector&, int component)>;

  PointData(const Box& box, const Materials& materials, const std::vector<Field>& fields)
  {
    box_ = box;
    materials_ = materials;
    fields_ = fields;
    functions_.resize(fields.size());
    ranges_.resize(fields.size(), 1.0);
    magnitudes_.resize(fields.size(), 1.0);
  }

  void setField(FieldId field, Function function) { functions_[at(field)] = std::move(function); }
  void addSample(const Vector& position, MaterialSet materials)
  {
    positions_.push_back(position);
    sets_.push_back(materials);
  }
  /// n^3 samples at the centers of equal parts of the box, in the materials that `materialsOf` says.
  template<class MaterialsOf>
  void addGrid(int n, MaterialsOf&& materialsOf)
  {
    for (int cell = 0; cell < n * n * n; ++cell)
    {
      const Vector index(cell % n, cell / n % n, cell / (n * n));
      const Vector p = box_.lower + (index.array() + 0.5).matrix().cwiseProduct(box_.size()) / n;
      addSample(p, materialsOf(p));
    }
  }

  SampleIndex sampleCount() const override { return static_cast<SampleIndex>(positions_.size()); }
  void positions(const SampleIndex* samples, Index count, Vector* result) const override
  {
    std::transform(samples, samples + count, result, [this](SampleIndex s) { return positions_[s]; });
  }
  void materialsAt(const SampleIndex* samples, Index count, MaterialSet* result) const override
  {
    std::transform(samples, samples + count, result, [this](SampleIndex s) { return sets_[s]; });
  }
  void values(FieldId field, MaterialId m, const SampleIndex* samples, Index count, double* result) const override
  {
    const int components = fields_[at(field)].components;
    for (Index i = 0; i < count * components; ++i)
    {
      result[i] = functions_[at(field)](m, positions_[samples[i / components]], static_cast<int>(i % components));
    }
  }
  void evaluate(MaterialId m, const Vector& point, bool, const Vector&, GhostMethod, double* result) const override
  {
    for (std::size_t f = 0; f < fields_.size(); ++f)
    {
      for (int c = 0; c < fields_[f].components; ++c)
      {
        *result++ = functions_[f](m, point, c);
      }
    }
  }

private:
  static std::size_t at(FieldId field) { return static_cast<std::size_t>(field.value); }

  std::vector<Vector> positions_;
  std::vector<MaterialSet> sets_;
  std::vector<Function> functions_;
};
}
