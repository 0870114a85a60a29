#include "Build/CellRowsOf.h"

#include "Build/BoxCut.h"
#include "Build/CellFunctions.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
CellRows::Weights weightsAt(const Barycentric& barycentric, const Vector& p)
{
  return { barycentric.weights[0](p), barycentric.weights[1](p), barycentric.weights[2](p), barycentric.weights[3](p) };
}

void addSamples(const Hierarchy& hierarchy, MaterialId m, const std::vector<SampleIndex>& ids,
  const std::vector<CellRows::Weights>& weights, const NativeData& native, CellRows& rows)
{
  int position = 1;
  for (std::size_t f = 0; f < hierarchy.fields.size(); ++f)
  {
    CellRows::Samples group;
    group.material = m;
    group.field = f;
    group.firstValue = position;
    group.components = hierarchy.fields[f].components;
    group.weights = weights;
    group.values.resize(ids.size() * static_cast<std::size_t>(group.components));
    native.values(FieldId(static_cast<Index>(f)), m, ids.data(), static_cast<Index>(ids.size()), group.values.data());
    position += group.components;
    rows.samples.push_back(std::move(group));
  }
}

void addInterfaceVertices(
  const Barycentric& barycentric, const CellElements& elements, const InterfaceElements& interfaces, CellRows& rows)
{
  std::vector<std::vector<CellRows::Weights>> byPair(interfaces.pairs.size());
  for (std::uint32_t i = 0; i < elements.vertexCount(); ++i)
  {
    const std::uint32_t vertex = elements.vertices()[i];
    for (std::int32_t k = interfaces.vertexPairOffsets[vertex]; k < interfaces.vertexPairOffsets[vertex + 1]; ++k)
    {
      byPair[static_cast<std::size_t>(interfaces.vertexPairs[static_cast<std::size_t>(k)])].push_back(
        weightsAt(barycentric, interfaces.points[vertex]));
    }
  }
  for (std::size_t pair = 0; pair < byPair.size(); ++pair)
  {
    if (!byPair[pair].empty())
    {
      rows.interfaces.push_back(
        { interfaces.pairs[pair].positive, interfaces.pairs[pair].negative, std::move(byPair[pair]) });
    }
  }
}
}

namespace
{
/// Cells with more native cells or triangles than this have samples or interface vertices enough.
constexpr std::uint32_t fewElements = 64;

CellRows::InterfaceVertices& groupOf(CellRows& rows, const InterfaceElements::Pair& pair)
{
  const auto found =
    std::find_if(rows.interfaces.begin(), rows.interfaces.end(), [&](const CellRows::InterfaceVertices& group) {
      return group.positive == pair.positive && group.negative == pair.negative;
    });
  return found != rows.interfaces.end()
           ? *found
           : rows.interfaces.emplace_back(CellRows::InterfaceVertices{ pair.positive, pair.negative, {} });
}

CellRows::Samples& groupOf(CellRows& rows, MaterialId m, std::size_t field, int firstValue, int components)
{
  const auto found = std::find_if(rows.samples.begin(), rows.samples.end(),
    [&](const CellRows::Samples& group) { return group.material == m && group.field == field; });
  return found != rows.samples.end()
           ? *found
           : rows.samples.emplace_back(CellRows::Samples{ m, field, firstValue, components, {}, {} });
}

/// A cell's corners and three points of each edge, and which materials' values have been found at each.
struct Probes
{
  std::array<Vector, 22> points;
  std::array<MaterialSet, 22> found;

  explicit Probes(const std::array<Vector, 4>& corners)
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      points[count++] = corners[i];
      for (std::size_t j = 0; j < i; ++j)
      {
        for (const double t : { 0.25, 0.5, 0.75 })
        {
          points[count++] = (1.0 - t) * corners[i] + t * corners[j];
        }
      }
    }
  }
};

/// Adds the values of one material of a box-shaped native cell at a point of it.
void addPoint(const Hierarchy& hierarchy, const NativeData& native, MaterialId m, const NativeCell& cell,
  const Vector& inBox, const CellRows::Weights& weights, CellRows& rows)
{
  int position = 1;
  for (std::size_t f = 0; f < hierarchy.fields.size(); ++f)
  {
    const int components = hierarchy.fields[f].components;
    std::vector<double> corners(static_cast<std::size_t>(8 * components));
    native.values(FieldId(static_cast<Index>(f)), m, cell.samples.data(), 8, corners.data());
    if (!std::isnan(corners[0]))
    {
      CellRows::Samples& group = groupOf(rows, m, f, position, components);
      group.weights.push_back(weights);
      for (int c = 0; c < components; ++c)
      {
        std::array<double, 8> values;
        for (std::size_t i = 0; i < 8; ++i)
        {
          values[i] = corners[i * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)];
        }
        group.values.push_back(MultilinearFunction(values)(inBox));
      }
    }
    position += components;
  }
}
}

void addClippedCorners(
  const Barycentric& barycentric, const CellElements& elements, const InterfaceElements& interfaces, CellRows& rows)
{
  if (elements.triangleCount() > fewElements)
  {
    return;
  }
  for (std::uint32_t i = 0; i < elements.triangleCount(); ++i)
  {
    const std::uint32_t triangle = elements.triangles()[i];
    const auto& [a, b, c] = interfaces.triangles[triangle];
    const ClippedTriangle clipped(
      barycentric, { interfaces.points[static_cast<std::size_t>(a)], interfaces.points[static_cast<std::size_t>(b)],
                     interfaces.points[static_cast<std::size_t>(c)] });
    if (clipped.whole() || clipped.empty())
    {
      // Its corners are interface vertices, which are there already.
      continue;
    }
    const auto pair = static_cast<std::size_t>(interfaces.pairOfTriangle[triangle]);
    CellRows::InterfaceVertices& group = groupOf(rows, interfaces.pairs[pair]);
    std::transform(clipped.begin(), clipped.end(), std::back_inserter(group.weights),
      [&](const Vector& p) { return weightsAt(barycentric, p); });
  }
}

void addNativeCellPoints(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const NativeData& native, CellRows& rows)
{
  if (elements.nativeCellCount() > fewElements)
  {
    return;
  }
  Probes probes(cornerPositions(hierarchy, cell));
  for (std::uint32_t i = 0; i < elements.nativeCellCount(); ++i)
  {
    const NativeCell element = native.nativeCell(elements.nativeCells()[i]);
    if (element.kind != NativeCell::Kind::Box)
    {
      continue;
    }
    for (std::size_t k = 0; k < probes.points.size(); ++k)
    {
      const Vector inBox =
        (probes.points[k] - element.corners[0]).cwiseQuotient(element.corners[7] - element.corners[0]);
      if (inBox.minCoeff() < 0.0 || inBox.maxCoeff() > 1.0)
      {
        continue;
      }
      for (const MaterialId m : (element.materials & hierarchy.materialsOf(cell)) - probes.found[k])
      {
        addPoint(hierarchy, native, m, element, inBox, weightsAt(barycentric, probes.points[k]), rows);
        probes.found[k].insert(m);
      }
    }
  }
}

CellRows cellRows(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric, const CellElements& elements,
  const NativeData& native, const InterfaceElements& interfaces)
{
  CellRows rows;
  for (std::size_t k = 0; k < 4; ++k)
  {
    rows.gradients[k] = barycentric.weights[k].gradient;
  }
  std::vector<Vector> positions(elements.sampleCount());
  std::vector<MaterialSet> sets(elements.sampleCount());
  native.positions(elements.samples(), elements.sampleCount(), positions.data());
  native.materialsAt(elements.samples(), elements.sampleCount(), sets.data());
  for (const MaterialId m : hierarchy.materialsOf(cell))
  {
    std::vector<SampleIndex> ids;
    std::vector<CellRows::Weights> weights;
    for (std::size_t i = 0; i < sets.size(); ++i)
    {
      if (sets[i].contains(m))
      {
        ids.push_back(elements.samples()[i]);
        weights.push_back(weightsAt(barycentric, positions[i]));
      }
    }
    if (!ids.empty())
    {
      addSamples(hierarchy, m, ids, weights, native, rows);
    }
  }
  addInterfaceVertices(barycentric, elements, interfaces, rows);
  return rows;
}
}
