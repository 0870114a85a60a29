#include "Build/CellRowsOf.h"

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
