#include "Measure/FieldErrors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace strata
{
namespace
{
/// Samples whose sums are formed together, in their order: the result doesn't depend on the number of threads.
constexpr Index samplesPerBlock = 4096;
/// Blocks between two reports of progress.
constexpr Index blocksPerBatch = 64;

struct Sums
{
  Index samples = 0;
  Index missing = 0;
  double largest = -1.0;
  double sum = 0.0;
  double sumOfSquares = 0.0;
  Vector where = Vector::Zero();

  void add(double error, const Vector& position)
  {
    ++samples;
    if (std::isinf(error))
    {
      ++missing;
    }
    else
    {
      sum += error;
      sumOfSquares += error * error;
    }
    note(error, position);
  }
  void add(const Sums& later)
  {
    samples += later.samples;
    missing += later.missing;
    sum += later.sum;
    sumOfSquares += later.sumOfSquares;
    note(later.largest, later.where);
  }

private:
  void note(double error, const Vector& position)
  {
    if (error > largest)
    {
      largest = error;
      where = position;
    }
  }
};

struct Location
{
  std::int64_t cell = -1;
  TetrahedronLocator::Weights weights{};
};

/// A field of the native data that the representation has too.
struct MatchedField
{
  FieldId field;
  int components = 1;
  const std::vector<const float*>* values = nullptr; ///< [material]
};

class FieldErrorMeasure
{
public:
  FieldErrorMeasure(const Representation& representation, const NativeData& native, const TetrahedronLocator& locator);

  std::vector<FieldErrorReport> run(Progress& progress) const;

private:
  std::vector<FieldErrorReport> reports(const std::vector<Sums>& total) const;
  void addBlock(Index begin, Index end, std::vector<Sums>& sums) const;
  void addSamples(MaterialId m, const std::vector<SampleIndex>& samples, std::vector<Sums>& sums) const;
  Location locate(const Vector& p, MaterialId m, std::int64_t likelyCell) const;
  bool hasValues(std::int64_t cell, MaterialId m) const;
  double error(const MatchedField& field, MaterialId m, const Location& location, const double* native) const;
  Sums& sumsOf(std::vector<Sums>& sums, std::size_t field, MaterialId m) const
  {
    return sums[field * representation_.materials.size() + static_cast<std::size_t>(m.value)];
  }

  const Representation& representation_;
  const NativeData& native_;
  const TetrahedronLocator& locator_;
  std::vector<MatchedField> fields_;
};

FieldErrorMeasure::FieldErrorMeasure(
  const Representation& representation, const NativeData& native, const TetrahedronLocator& locator) :
  representation_(representation),
  native_(native), locator_(locator)
{
  for (std::size_t i = 0; i < native.fields().size(); ++i)
  {
    const auto found = std::find_if(representation.fields.begin(), representation.fields.end(),
      [&](const Field& field) { return field.name == native.fields()[i].name; });
    if (found != representation.fields.end())
    {
      fields_.push_back({ FieldId(static_cast<Index>(i)), found->components,
        &representation.values[static_cast<std::size_t>(found - representation.fields.begin())] });
    }
  }
}

/// Whether a cell has the values of m at its four vertices, in all fields that m has.
bool FieldErrorMeasure::hasValues(std::int64_t cell, MaterialId m) const
{
  const std::int64_t* corners = representation_.tetrahedra + 4 * cell;
  return std::all_of(fields_.begin(), fields_.end(), [&](const MatchedField& field) {
    const float* values = (*field.values)[m.value];
    return !values || std::none_of(corners, corners + 4,
                        [&](std::int64_t corner) { return std::isnan(values[corner * field.components]); });
  });
}

/// A cell that holds the point and has m's values, else any that holds the point.
Location FieldErrorMeasure::locate(const Vector& p, MaterialId m, std::int64_t likelyCell) const
{
  Location location;
  if (likelyCell >= 0 && hasValues(likelyCell, m) && locator_.holds(likelyCell, p, location.weights))
  {
    location.cell = likelyCell;
    return location;
  }
  locator_.visitCells(p, [&](std::int64_t cell, const TetrahedronLocator::Weights& weights) {
    location = { cell, weights };
    return hasValues(cell, m);
  });
  return location;
}

double FieldErrorMeasure::error(
  const MatchedField& field, MaterialId m, const Location& location, const double* native) const
{
  const float* values = (*field.values)[m.value];
  double squared = 0.0;
  for (int c = 0; c < field.components; ++c)
  {
    double represented = std::numeric_limits<double>::quiet_NaN();
    if (values && location.cell >= 0)
    {
      const std::int64_t* corners = representation_.tetrahedra + 4 * location.cell;
      represented = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        represented += location.weights[i] * static_cast<double>(values[corners[i] * field.components + c]);
      }
    }
    squared += (native[c] - represented) * (native[c] - represented);
  }
  return std::isnan(squared) ? std::numeric_limits<double>::infinity() : std::sqrt(squared);
}

void FieldErrorMeasure::addBlock(Index begin, Index end, std::vector<Sums>& sums) const
{
  std::vector<SampleIndex> samples(static_cast<std::size_t>(end - begin));
  std::iota(samples.begin(), samples.end(), static_cast<SampleIndex>(begin));
  std::vector<MaterialSet> sets(samples.size());
  native_.materialsAt(samples.data(), end - begin, sets.data());
  const MaterialSet present = std::accumulate(
    sets.begin(), sets.end(), MaterialSet(), [](MaterialSet all, MaterialSet set) { return all | set; });
  for (const MaterialId m : present)
  {
    std::vector<SampleIndex> ofMaterial;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(ofMaterial),
      [&](SampleIndex sample) { return sets[static_cast<std::size_t>(sample - begin)].contains(m); });
    addSamples(m, ofMaterial, sums);
  }
}

void FieldErrorMeasure::addSamples(MaterialId m, const std::vector<SampleIndex>& samples, std::vector<Sums>& sums) const
{
  const auto count = static_cast<Index>(samples.size());
  std::vector<Vector> positions(samples.size());
  native_.positions(samples.data(), count, positions.data());
  std::vector<Location> locations;
  locations.reserve(samples.size());
  for (const Vector& position : positions)
  {
    locations.push_back(locate(position, m, locations.empty() ? -1 : locations.back().cell));
  }
  for (std::size_t f = 0; f < fields_.size(); ++f)
  {
    const auto components = static_cast<std::size_t>(fields_[f].components);
    std::vector<double> values(samples.size() * components);
    native_.values(fields_[f].field, m, samples.data(), count, values.data());
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const double* value = values.data() + i * components;
      if (std::none_of(value, value + components, [](double x) { return std::isnan(x); }))
      {
        sumsOf(sums, f, m).add(error(fields_[f], m, locations[i], value), positions[i]);
      }
    }
  }
}

std::vector<FieldErrorReport> FieldErrorMeasure::run(Progress& progress) const
{
  const auto sampleCount = static_cast<Index>(native_.sampleCount());
  const Index blockCount = (sampleCount + samplesPerBlock - 1) / samplesPerBlock;
  std::vector<Sums> total(fields_.size() * representation_.materials.size());
  for (Index batch = 0; batch < blockCount; batch += blocksPerBatch)
  {
    progress.update(static_cast<double>(batch) / static_cast<double>(blockCount));
    const Index blocks = std::min(blocksPerBatch, blockCount - batch);
    std::vector<std::vector<Sums>> partial(static_cast<std::size_t>(blocks), std::vector<Sums>(total.size()));
    tbb::parallel_for(Index{ 0 }, blocks, [&](Index block) {
      progress.check();
      const Index begin = (batch + block) * samplesPerBlock;
      addBlock(begin, std::min(begin + samplesPerBlock, sampleCount), partial[static_cast<std::size_t>(block)]);
    });
    for (const std::vector<Sums>& sums : partial)
    {
      for (std::size_t i = 0; i < total.size(); ++i)
      {
        total[i].add(sums[i]);
      }
    }
  }
  return reports(total);
}

std::vector<FieldErrorReport> FieldErrorMeasure::reports(const std::vector<Sums>& total) const
{
  std::vector<FieldErrorReport> result;
  for (std::size_t i = 0; i < total.size(); ++i)
  {
    const Sums& sums = total[i];
    if (sums.samples == 0)
    {
      continue;
    }
    FieldErrorReport report;
    report.field = fields_[i / representation_.materials.size()].field;
    report.material = MaterialId(static_cast<Index>(i % representation_.materials.size()));
    report.samples = sums.samples;
    report.missing = sums.missing;
    report.largest = sums.largest;
    report.where = sums.where;
    if (const auto known = static_cast<double>(sums.samples - sums.missing); known > 0.0)
    {
      report.mean = sums.sum / known;
      report.rootMeanSquare = std::sqrt(sums.sumOfSquares / known);
    }
    result.push_back(report);
  }
  return result;
}
}

std::vector<FieldErrorReport> measureFields(
  const Representation& representation, const NativeData& native, const TetrahedronLocator& locator, Progress& progress)
{
  return FieldErrorMeasure(representation, native, locator).run(progress);
}
}
