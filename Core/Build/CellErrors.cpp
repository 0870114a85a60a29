#include "Build/CellErrors.h"

#include "Build/CellFunctions.h"

#include <cmath>

namespace strata
{
namespace
{
/// Samples of one material in a cell, ready for comparison.
struct SamplesOfMaterial
{
  std::vector<SampleIndex> ids;
  std::vector<Vector> positions;
};

/// Largest length of native - represented over the samples where the field is known.
double largestDifference(const std::vector<LinearFunction>& represented, const std::vector<double>& nativeValues,
  const std::vector<Vector>& positions)
{
  const std::size_t components = represented.size();
  double largest2 = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    double squared = 0.0;
    for (std::size_t c = 0; c < components; ++c)
    {
      const double difference = nativeValues[i * components + c] - represented[c](positions[i]);
      squared += difference * difference;
    }
    // A NaN (a field that is not known at this sample) compares false.
    largest2 = squared > largest2 ? squared : largest2;
  }
  return std::sqrt(largest2);
}

void addFieldErrors(const Hierarchy& hierarchy, const HierarchyCell& cell, const Barycentric& barycentric,
  const NativeData& native, MaterialId m, const SamplesOfMaterial& samples, CellErrors& errors)
{
  const MaterialCorners corners = materialCorners(hierarchy, cell, m);
  int position = 1;
  for (std::size_t f = 0; f < hierarchy.fields.size(); ++f)
  {
    const int components = hierarchy.fields[f].components;
    std::vector<LinearFunction> represented;
    for (int c = 0; c < components; ++c)
    {
      represented.push_back(representedFunction(barycentric, corners, position + c));
    }
    position += components;
    std::vector<double> values(samples.ids.size() * static_cast<std::size_t>(components));
    native.values(
      FieldId(static_cast<Index>(f)), m, samples.ids.data(), static_cast<Index>(samples.ids.size()), values.data());
    errors.fieldErrors[f] =
      std::max(errors.fieldErrors[f], roundedUp(largestDifference(represented, values, samples.positions)));
  }
}

/// Sorts a block of samples by material and compares each material's.
void addSampleBlock(const Hierarchy& hierarchy, const HierarchyCell& cell, const Barycentric& barycentric,
  const NativeData& native, const SampleIndex* ids, Index count, MaterialSet cellMaterials, CellErrors& errors)
{
  std::vector<Vector> positions(static_cast<std::size_t>(count));
  std::vector<MaterialSet> sets(static_cast<std::size_t>(count));
  native.positions(ids, count, positions.data());
  native.materialsAt(ids, count, sets.data());
  for (const MaterialId m : cellMaterials)
  {
    SamplesOfMaterial samples;
    for (std::size_t i = 0; i < sets.size(); ++i)
    {
      if (sets[i].contains(m))
      {
        samples.ids.push_back(ids[i]);
        samples.positions.push_back(positions[i]);
      }
    }
    if (!samples.ids.empty())
    {
      addFieldErrors(hierarchy, cell, barycentric, native, m, samples, errors);
    }
  }
}

double interfaceError(const Hierarchy& hierarchy, const HierarchyCell& cell, const Barycentric& barycentric,
  const CellElements& elements, const InterfaceElements& interfaces)
{
  std::vector<std::pair<bool, LinearFunction>> planes(interfaces.pairs.size());
  double largest = 0.0;
  for (std::uint32_t i = 0; i < elements.vertexCount(); ++i)
  {
    const std::uint32_t vertex = elements.vertices()[i];
    for (std::int32_t k = interfaces.vertexPairOffsets[vertex]; k < interfaces.vertexPairOffsets[vertex + 1]; ++k)
    {
      const auto pair = static_cast<std::size_t>(interfaces.vertexPairs[static_cast<std::size_t>(k)]);
      if (!planes[pair].first)
      {
        const InterfaceElements::Pair& materials = interfaces.pairs[pair];
        const LinearFunction a =
          representedFunction(barycentric, materialCorners(hierarchy, cell, materials.positive), 0);
        const LinearFunction b =
          representedFunction(barycentric, materialCorners(hierarchy, cell, materials.negative), 0);
        planes[pair] = { true, { b.constant - a.constant, b.gradient - a.gradient } };
      }
      largest = std::max(largest, distanceToPlane(planes[pair].second, interfaces.points[vertex]));
    }
  }
  return largest;
}
}

float roundedUp(double value)
{
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
                                              : nearest;
}

CellErrors cellErrors(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const NativeData& native, const InterfaceElements& interfaces)
{
  constexpr Index blockSize = 4096;
  const HierarchyCell& tetrahedron = hierarchy.cell(cell);
  CellErrors errors;
  errors.fieldErrors.assign(hierarchy.fields.size(), 0.0f);
  for (Index begin = 0; begin < elements.sampleCount(); begin += blockSize)
  {
    addSampleBlock(hierarchy, tetrahedron, barycentric, native, elements.samples() + begin,
      std::min<Index>(blockSize, elements.sampleCount() - begin), hierarchy.materialsOf(cell), errors);
  }
  if (elements.vertexCount() > 0)
  {
    errors.interfaceError = roundedUp(interfaceError(hierarchy, tetrahedron, barycentric, elements, interfaces));
  }
  return errors;
}
}
