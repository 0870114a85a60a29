#pragma once

#include "Model/Lattice.h"
#include "Model/Materials.h"
#include "Model/NativeData.h"

#include <vector>

namespace strata
{
using CellId = Id<struct CellTag>;
using VertexId = Id<struct VertexTag>;
using DiamondId = Id<struct DiamondTag>;

/// A tetrahedron of the hierarchy. Maubach's bisection: with tag t it splits at the midpoint of its corners 0
/// and t. Its two children are neighbours in Hierarchy::cells.
struct HierarchyCell
{
  std::array<VertexId, 4> corners;
  DiamondId diamond;
  CellId firstChild;
  CellId nextInDiamond;
  std::uint8_t tag = 3;
  std::uint8_t level = 0;
  bool inverted = false; ///< whether its corners are negatively oriented
};

/// All tetrahedra round one split edge. They split together, which keeps the mesh conforming.
struct Diamond
{
  LatticePoint center;
  CellId firstCell;
  VertexId vertex; ///< made when the diamond splits
  /// Filled when the diamond splits; invalid where there are fewer.
  std::array<DiamondId, 4> parents;
};

/// Finds diamonds by their centres (open addressing).
class DiamondTable
{
public:
  /// Invalid if there is none.
  DiamondId find(const LatticePoint& center, const std::vector<Diamond>& diamonds) const;
  /// Enters the diamond, whose centre must not be in the table.
  void insert(DiamondId id, const std::vector<Diamond>& diamonds);
  /// Follows the diamonds to new places.
  void renumber(const std::vector<std::int32_t>& newPlaces);

private:
  std::size_t slotOf(const LatticePoint& center, const std::vector<Diamond>& diamonds) const;
  std::vector<DiamondId> slots_;
  std::size_t used_ = 0;
};

/// All tetrahedra made so far, from the base mesh down, with their errors, and the values at their vertices.
///
/// Invariants: a diamond is split only if its parents (Lattice::parents) are, so that all its cells exist; the
/// values at a vertex are a function of its place and the input alone; a vertex has values for every material
/// that any cell round it, on any level, needs.
struct Hierarchy
{
  Lattice lattice;
  Materials materials;
  std::vector<Field> fields;

  std::vector<HierarchyCell> cells; ///< the base mesh first: six per cube
  Index rootCount = 0;
  std::vector<MaterialSet> cellMaterials; ///< what the cell holds: pieces of regions, or native samples
  std::vector<float> interfaceErrors;     ///< one per cell, rounded up
  std::vector<float> fieldErrors;         ///< [cell * fields + field], rounded up

  std::vector<Diamond> diamonds;
  DiamondTable table;

  std::vector<LatticePoint> vertices;
  std::vector<MaterialSet> vertexMaterials;
  std::vector<Index> valueOffsets; ///< where a vertex's values begin
  /// For each material of the vertex in ascending order: its distance, then the components of its fields.
  std::vector<float> values;
  int valuesPerMaterial = 1;

  const HierarchyCell& cell(CellId id) const { return cells[static_cast<std::size_t>(id.value)]; }
  const Diamond& diamond(DiamondId id) const { return diamonds[static_cast<std::size_t>(id.value)]; }
  bool isSplit(DiamondId id) const { return diamond(id).vertex.valid(); }
  DiamondId diamondAt(const LatticePoint& center) const { return table.find(center, diamonds); }
  MaterialSet materialsOf(CellId id) const { return cellMaterials[static_cast<std::size_t>(id.value)]; }
  float interfaceError(CellId id) const { return interfaceErrors[static_cast<std::size_t>(id.value)]; }
  float fieldError(CellId id, std::size_t field) const
  {
    return fieldErrors[static_cast<std::size_t>(id.value) * fields.size() + field];
  }
  Vector position(VertexId id) const { return lattice.position(vertices[static_cast<std::size_t>(id.value)]); }
  /// The distance to m's region and then m's field components at a vertex; null if the vertex has none of m.
  const float* valuesOf(VertexId vertex, MaterialId m) const;
  /// Calls visit(CellId) for every cell of a diamond.
  template<typename Visit>
  void forCellsOf(DiamondId id, Visit visit) const
  {
    for (CellId c = diamond(id).firstCell; c.valid(); c = cell(c).nextInDiamond)
    {
      visit(c);
    }
  }
};
}
