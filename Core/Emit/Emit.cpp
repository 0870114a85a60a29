#include "Emit/Emit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>

namespace strata
{
namespace
{
constexpr Index itemsPerBlock = 4096;
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

/// Calls body(i) for i in [0, count), in parallel blocks between which the user may stop.
template<typename Body>
void forEach(Index count, Progress& progress, const Body& body)
{
  const Index blocks = (count + itemsPerBlock - 1) / itemsPerBlock;
  tbb::parallel_for(Index{ 0 }, blocks, [&](Index block) {
    progress.check();
    const Index end = std::min(count, (block + 1) * itemsPerBlock);
    for (Index i = block * itemsPerBlock; i < end; ++i)
    {
      body(i);
    }
  });
}

/// One emission: a level's cells and vertices, and the mesh that is being filled.
class Emitter
{
public:
  Emitter(const Hierarchy& hierarchy, const Level& level, LevelCells&& cells, const EmitOptions& options,
    Progress& progress) :
    hierarchy_(hierarchy),
    level_(level), options_(options), progress_(progress), cells_(std::move(cells))
  {
    mesh_.materials = hierarchy.materials;
    mesh_.fields = hierarchy.fields;
    mesh_.achieved = level.achieved;
  }

  Mesh run()
  {
    allocateVertexArrays();
    forEach(vertexCount(), progress_, [this](Index number) { emitVertex(number); });
    allocateCellArrays();
    forEach(cellCount(), progress_, [this](Index i) { emitCell(i); });
    mesh_.tetrahedra = std::move(cells_.tetrahedra);
    findAchievedErrors();
    if (!options_.distances)
    {
      mesh_.distances = std::vector<Buffer<float>>(hierarchy_.materials.size());
    }
    return std::move(mesh_);
  }

private:
  Index vertexCount() const { return static_cast<Index>(cells_.vertices.size()); }
  Index cellCount() const { return static_cast<Index>(cells_.cells.size()); }

  void allocateCellArrays();
  void emitCell(Index i);
  MaterialId fillingMaterial(Index i) const;
  void allocateVertexArrays();
  void emitVertex(Index number);
  void emitMaterialAtVertex(Index number, MaterialId m, const float* values);
  void emitComposite(Index number, const float* values);
  void findAchievedErrors();

  const Hierarchy& hierarchy_;
  const Level& level_;
  const EmitOptions& options_;
  Progress& progress_;
  LevelCells cells_;
  Mesh mesh_;
};

void Emitter::allocateCellArrays()
{
  const Index count = cellCount();
  mesh_.cellMaterial = Buffer<std::int32_t>(count);
  mesh_.cellLevel = Buffer<std::int32_t>(count);
  mesh_.cellInterfaceError = Buffer<float>(count);
  for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
  {
    mesh_.cellFieldErrors.emplace_back(count);
  }
}

void Emitter::emitCell(Index i)
{
  const CellId id = cells_.cells[static_cast<std::size_t>(i)];
  mesh_.cellMaterial[i] = fillingMaterial(i).value;
  mesh_.cellLevel[i] = hierarchy_.cell(id).level;
  mesh_.cellInterfaceError[i] = hierarchy_.interfaceError(id);
  for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
  {
    mesh_.cellFieldErrors[f][i] = hierarchy_.fieldError(id, f);
  }
}

/// The material that is nearest at all corners, hence everywhere in the cell; none if the cell is mixed.
MaterialId Emitter::fillingMaterial(Index i) const
{
  const MaterialSet candidates = cells_.atAllCorners(static_cast<std::size_t>(i));
  MaterialSet winners = candidates;
  for (std::size_t k = 0; k < 4 && candidates.size() > 1; ++k)
  {
    const std::int64_t corner = cells_.tetrahedra[4 * i + static_cast<Index>(k)];
    const auto distance = [&](MaterialId m) { return mesh_.distances[static_cast<std::size_t>(m.value)][corner]; };
    float smallest = std::numeric_limits<float>::infinity();
    for (const MaterialId m : candidates)
    {
      smallest = std::min(smallest, distance(m));
    }
    for (const MaterialId m : winners)
    {
      if (distance(m) > smallest)
      {
        winners.erase(m);
      }
    }
  }
  return winners.empty() ? MaterialId() : winners.first();
}

void Emitter::allocateVertexArrays()
{
  const Index count = vertexCount();
  mesh_.points = Buffer<double>(3 * count);
  mesh_.vertexMaterial = Buffer<std::int32_t>(count);
  mesh_.values.resize(hierarchy_.fields.size());
  for (const Material& material : hierarchy_.materials)
  {
    mesh_.distances.emplace_back(count);
    const bool ghosts = options_.ghosts && material.hasFields;
    mesh_.ghosts.push_back(ghosts ? Buffer<std::uint8_t>(count) : Buffer<std::uint8_t>());
    for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
    {
      const bool values = options_.perMaterialValues && material.hasFields;
      mesh_.values[f].push_back(values ? Buffer<float>(count * hierarchy_.fields[f].components) : Buffer<float>());
    }
  }
  for (const Field& field : hierarchy_.fields)
  {
    mesh_.composite.emplace_back(count * field.components);
  }
}

void Emitter::emitVertex(Index number)
{
  const VertexId vertex = cells_.vertices[static_cast<std::size_t>(number)];
  const Vector position = hierarchy_.position(vertex);
  std::copy_n(position.data(), 3, mesh_.points.data() + 3 * number);
  const MaterialSet needed = cells_.needs[static_cast<std::size_t>(number)];
  MaterialId own;
  const float* ownValues = nullptr;
  for (std::size_t m = 0; m < hierarchy_.materials.size(); ++m)
  {
    const MaterialId material(static_cast<Index>(m));
    const float* values = needed.contains(material) ? level_.valuesOf(hierarchy_, vertex, material) : nullptr;
    emitMaterialAtVertex(number, material, values);
    if (values && (!ownValues || *values < *ownValues))
    {
      own = material;
      ownValues = values;
    }
  }
  mesh_.vertexMaterial[number] = own.value;
  if (mesh_.ghosts[static_cast<std::size_t>(own.value)].size() > 0)
  {
    mesh_.ghosts[static_cast<std::size_t>(own.value)][number] = 0;
  }
  emitComposite(number, ownValues + 1);
}

void Emitter::emitMaterialAtVertex(Index number, MaterialId m, const float* values)
{
  const auto index = static_cast<std::size_t>(m.value);
  mesh_.distances[index][number] = values ? values[0] : notANumber;
  if (mesh_.ghosts[index].size() > 0)
  {
    mesh_.ghosts[index][number] = values ? 1 : 2;
  }
  int position = 1;
  for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
  {
    const int components = hierarchy_.fields[f].components;
    Buffer<float>& array = mesh_.values[f][index];
    for (int c = 0; c < components && array.size() > 0; ++c)
    {
      array[number * components + c] = values ? values[position + c] : notANumber;
    }
    position += components;
  }
}

/// The values of the material that the vertex lies in.
void Emitter::emitComposite(Index number, const float* values)
{
  for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
  {
    const int components = hierarchy_.fields[f].components;
    std::copy_n(values, components, mesh_.composite[f].data() + number * components);
    values += components;
  }
}

void Emitter::findAchievedErrors()
{
  const auto largest = [](const Buffer<float>& errors) {
    return errors.size() > 0 ? static_cast<double>(*std::max_element(errors.begin(), errors.end())) : 0.0;
  };
  mesh_.achieved.interfaceError = largest(mesh_.cellInterfaceError);
  mesh_.achieved.fieldErrors.clear();
  for (const Buffer<float>& errors : mesh_.cellFieldErrors)
  {
    mesh_.achieved.fieldErrors.push_back(largest(errors));
  }
}
}

Mesh emitMesh(
  const Hierarchy& hierarchy, const Level& level, LevelCells&& cells, const EmitOptions& options, Progress& progress)
{
  return Emitter(hierarchy, level, std::move(cells), options, progress).run();
}
}
