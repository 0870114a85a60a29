#include "Emit/Emit.h"

#include "Emit/LeafCells.h"
#include "Emit/Needs.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <cmath>
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
  Emitter(const Hierarchy& hierarchy, const Level& level, const EmitOptions& options, Progress& progress) :
    hierarchy_(hierarchy), level_(level), options_(options), progress_(progress), cells_(leafCells(hierarchy, level)),
    needs_(hierarchy, level, cells_), numbering_(numberVertices(hierarchy, cells_))
  {
    mesh_.materials = hierarchy.materials;
    mesh_.fields = hierarchy.fields;
    mesh_.achieved = level.achieved;
  }

  Mesh run()
  {
    emitCells();
    emitVertices();
    findAchievedErrors();
    return std::move(mesh_);
  }

private:
  Index vertexCount() const { return static_cast<Index>(numbering_.vertices.size()); }
  Index cellCount() const { return static_cast<Index>(cells_.size()); }
  std::int32_t numberOf(VertexId v) const { return numbering_.numberOf[static_cast<std::size_t>(v.value)]; }
  const float* valuesOf(VertexId v, MaterialId m) const { return level_.valuesOf(hierarchy_, v, m); }

  void emitCells();
  void emitTetrahedron(Index i);
  bool isInverted(const HierarchyCell& cell) const;
  MaterialId fillingMaterial(const HierarchyCell& cell, MaterialSet candidates) const;
  void allocateVertexArrays();
  void emitVertices();
  void emitVertex(Index number);
  void emitMaterialAtVertex(Index number, VertexId vertex, MaterialId m, bool needed);
  MaterialId materialAt(VertexId vertex, MaterialSet candidates) const;
  void findAchievedErrors();

  const Hierarchy& hierarchy_;
  const Level& level_;
  const EmitOptions& options_;
  Progress& progress_;
  std::vector<CellId> cells_;
  Needs needs_;
  VertexNumbering numbering_;
  Mesh mesh_;
};

void Emitter::emitCells()
{
  const Index count = cellCount();
  mesh_.tetrahedra = Buffer<std::int64_t>(4 * count);
  mesh_.cellMaterial = Buffer<std::int32_t>(count);
  mesh_.cellLevel = Buffer<std::int32_t>(count);
  mesh_.cellInterfaceError = Buffer<float>(count);
  for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
  {
    mesh_.cellFieldErrors.emplace_back(count);
  }
  forEach(count, progress_, [this](Index i) { emitTetrahedron(i); });
}

/// Bisection turns orientations. The determinant of lattice differences has a safe sign in doubles: the shapes
/// are those of the Kuhn tetrahedra and their halves, never slivers.
bool Emitter::isInverted(const HierarchyCell& cell) const
{
  const auto edge = [&](std::size_t corner) {
    const LatticePoint& a = hierarchy_.vertices[static_cast<std::size_t>(cell.corners[0].value)];
    const LatticePoint& b = hierarchy_.vertices[static_cast<std::size_t>(cell.corners[corner].value)];
    return Vector(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  };
  return edge(1).cross(edge(2)).dot(edge(3)) < 0.0;
}

void Emitter::emitTetrahedron(Index i)
{
  const CellId id = cells_[static_cast<std::size_t>(i)];
  const HierarchyCell& cell = hierarchy_.cell(id);
  std::int64_t* corners = mesh_.tetrahedra.data() + 4 * i;
  for (std::size_t k = 0; k < 4; ++k)
  {
    corners[k] = numberOf(cell.corners[k]);
  }
  if (isInverted(cell))
  {
    std::swap(corners[2], corners[3]);
  }
  mesh_.cellMaterial[i] = fillingMaterial(cell, needs_.atAllCorners(cell)).value;
  mesh_.cellLevel[i] = cell.level;
  mesh_.cellInterfaceError[i] = hierarchy_.interfaceError(id);
  for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
  {
    mesh_.cellFieldErrors[f][i] = hierarchy_.fieldError(id, f);
  }
}

/// The material that is nearest at all corners, hence everywhere in the cell; none if the cell is mixed.
MaterialId Emitter::fillingMaterial(const HierarchyCell& cell, MaterialSet candidates) const
{
  if (candidates.size() == 1)
  {
    return candidates.first();
  }
  MaterialSet winners = candidates;
  for (const VertexId corner : cell.corners)
  {
    float smallest = std::numeric_limits<float>::infinity();
    for (const MaterialId m : candidates)
    {
      smallest = std::min(smallest, *valuesOf(corner, m));
    }
    for (const MaterialId m : winners)
    {
      if (*valuesOf(corner, m) > smallest)
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
    mesh_.distances.push_back(options_.distances ? Buffer<float>(count) : Buffer<float>());
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

void Emitter::emitVertices()
{
  allocateVertexArrays();
  forEach(vertexCount(), progress_, [this](Index number) { emitVertex(number); });
}

void Emitter::emitVertex(Index number)
{
  const VertexId vertex = numbering_.vertices[static_cast<std::size_t>(number)];
  const Vector position = hierarchy_.position(vertex);
  std::copy_n(position.data(), 3, mesh_.points.data() + 3 * number);
  const MaterialSet needed = needs_.at(vertex);
  const MaterialId own = materialAt(vertex, needed);
  mesh_.vertexMaterial[number] = own.value;
  for (std::size_t m = 0; m < hierarchy_.materials.size(); ++m)
  {
    const MaterialId material(static_cast<Index>(m));
    emitMaterialAtVertex(number, vertex, material, needed.contains(material));
    if (mesh_.ghosts[m].size() > 0)
    {
      mesh_.ghosts[m][number] = material == own ? 0 : (needed.contains(material) ? 1 : 2);
    }
  }
  const float* values = valuesOf(vertex, own) + 1;
  for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
  {
    const int components = hierarchy_.fields[f].components;
    std::copy_n(values, components, mesh_.composite[f].data() + number * components);
    values += components;
  }
}

void Emitter::emitMaterialAtVertex(Index number, VertexId vertex, MaterialId m, bool needed)
{
  const auto index = static_cast<std::size_t>(m.value);
  const float* values = needed ? valuesOf(vertex, m) : nullptr;
  if (options_.distances)
  {
    mesh_.distances[index][number] = values ? values[0] : notANumber;
  }
  int position = 1;
  for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
  {
    const int components = hierarchy_.fields[f].components;
    if (mesh_.values[f][index].size() > 0)
    {
      for (int c = 0; c < components; ++c)
      {
        mesh_.values[f][index][number * components + c] = values ? values[position + c] : notANumber;
      }
    }
    position += components;
  }
}

MaterialId Emitter::materialAt(VertexId vertex, MaterialSet candidates) const
{
  MaterialId nearest = candidates.first();
  for (const MaterialId m : candidates)
  {
    nearest = *valuesOf(vertex, m) < *valuesOf(vertex, nearest) ? m : nearest;
  }
  return nearest;
}

void Emitter::findAchievedErrors()
{
  float interface = 0.0f;
  std::vector<float> fields(hierarchy_.fields.size(), 0.0f);
  for (const CellId id : cells_)
  {
    interface = std::max(interface, hierarchy_.interfaceError(id));
    for (std::size_t f = 0; f < fields.size(); ++f)
    {
      fields[f] = std::max(fields[f], hierarchy_.fieldError(id, f));
    }
  }
  mesh_.achieved.interfaceError = static_cast<double>(interface);
  mesh_.achieved.fieldErrors.assign(fields.begin(), fields.end());
}
}

Mesh emitMesh(const Hierarchy& hierarchy, const Level& level, const EmitOptions& options, Progress& progress)
{
  return Emitter(hierarchy, level, options, progress).run();
}
}
