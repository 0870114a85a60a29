#pragma once

#include "Geometry/TriangleTree.h"
#include "Model/InterfacePiece.h"
#include "Model/Interfaces.h"

#include <map>
#include <memory>

namespace strata
{
/// The surface between each pair of materials, ready for distance queries, whichever of the two is the positive one.
class InterfaceTrees
{
public:
  /// The interfaces of a data set.
  explicit InterfaceTrees(const Interfaces& interfaces);
  /// Convex polygons; the surfaces' triangles come in the order of the lists.
  explicit InterfaceTrees(const std::vector<const std::vector<InterfacePiece>*>& pieces);

  /// Null where two materials don't touch.
  const TriangleTree* between(UnorderedPair materials) const;
  const std::map<UnorderedPair, std::unique_ptr<TriangleTree>>& all() const { return trees_; }

private:
  using Triangles = std::vector<std::array<Vector, 3>>;
  void makeTrees(std::map<UnorderedPair, Triangles> triangles);

  std::map<UnorderedPair, std::unique_ptr<TriangleTree>> trees_;
};

/// The boundary of each material's region: its interfaces with all others in one.
class RegionTrees
{
public:
  explicit RegionTrees(const InterfaceTrees& interfaces);

  /// Null where a material has no interface.
  const TriangleTree* around(MaterialId material) const;

private:
  std::map<MaterialId, std::unique_ptr<TriangleTree>> trees_;
};
}
