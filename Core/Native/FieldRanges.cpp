#include "Native/FieldRanges.h"

#include "Model/Errors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr Index chunkSize = 65536;

FieldRange emptyRange(std::size_t materialCount, int components)
{
  FieldRange result;
  result.materials.assign(materialCount, std::vector<Range>(static_cast<std::size_t>(components)));
  return result;
}

[[noreturn]] void throwNotFinite(const SimulationField& field, const std::string& material, Index sample, double value)
{
  throw InvalidInput("field \"" + field.name + "\" of material \"" + material + "\" is " + std::to_string(value) +
                     (field.association == Association::Cells ? " in cell " : " at point ") + std::to_string(sample));
}

/// A value that is not finite, with the sample and the material.
struct Flaw
{
  Index sample = -1;
  MaterialId material;
  double value = 0.0;
};

/// Adds a material's value at a sample to the ranges; false where it is not finite.
bool addSample(const ValueArray& values, Index sample, MaterialId m, FieldRange& range, double& flaw)
{
  std::vector<Range>& components = range.materials[static_cast<std::size_t>(m.value)];
  double squares = 0.0;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const double value = values(sample, static_cast<int>(c));
    if (!std::isfinite(value))
    {
      flaw = value;
      return false;
    }
    components[c].add(value);
    squares += value * value;
  }
  range.length.add(components.size() == 1 ? values(sample) : std::sqrt(squares));
  return true;
}

/// Adds the samples begin .. end - 1, up to the first flaw.
Flaw addSamples(const SimulationField& field, const SampleMaterials& samples, Index begin, Index end, FieldRange& range)
{
  for (Index sample = begin; sample < end; ++sample)
  {
    for (const MaterialId m : samples[sample])
    {
      const ValueArray& values = field.values[static_cast<std::size_t>(m.value)];
      double value = 0.0;
      if (values && !addSample(values, sample, m, range, value))
      {
        return { sample, m, value };
      }
    }
  }
  return {};
}

void addRange(const FieldRange& part, FieldRange& whole)
{
  whole.length.add(part.length);
  for (std::size_t m = 0; m < whole.materials.size(); ++m)
  {
    for (std::size_t c = 0; c < whole.materials[m].size(); ++c)
    {
      whole.materials[m][c].add(part.materials[m][c]);
    }
  }
}
}

FieldRange findRange(
  const SimulationField& field, const Materials& materials, const SampleMaterials& samples, Progress& progress)
{
  const Index chunkCount = (samples.size() + chunkSize - 1) / chunkSize;
  std::vector<FieldRange> parts(static_cast<std::size_t>(chunkCount));
  std::vector<Flaw> flaws(static_cast<std::size_t>(chunkCount));
  tbb::parallel_for(Index{ 0 }, chunkCount, [&](Index chunk) {
    progress.check();
    FieldRange& part = parts[static_cast<std::size_t>(chunk)];
    part = emptyRange(materials.size(), field.components);
    flaws[static_cast<std::size_t>(chunk)] =
      addSamples(field, samples, chunk * chunkSize, std::min(samples.size(), (chunk + 1) * chunkSize), part);
  });

  FieldRange result = emptyRange(materials.size(), field.components);
  for (std::size_t chunk = 0; chunk < parts.size(); ++chunk)
  {
    const Flaw& flaw = flaws[chunk];
    if (flaw.sample >= 0)
    {
      throwNotFinite(field, materials[static_cast<std::size_t>(flaw.material.value)].name, flaw.sample, flaw.value);
    }
    addRange(parts[chunk], result);
  }
  return result;
}
}
