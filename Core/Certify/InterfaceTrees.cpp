#include "Certify/InterfaceTrees.h"

namespace strata
{
InterfaceTrees::InterfaceTrees(const Interfaces& interfaces)
{
  std::map<UnorderedPair, Triangles> triangles;
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    Triangles& list = triangles[UnorderedPair::of(surface.positive, surface.negative)];
    for (const auto& [a, b, c] : surface.triangles)
    {
      list.push_back({ interfaces.points[static_cast<std::size_t>(a)], interfaces.points[static_cast<std::size_t>(b)],
        interfaces.points[static_cast<std::size_t>(c)] });
    }
  }
  makeTrees(std::move(triangles));
}

InterfaceTrees::InterfaceTrees(const std::vector<const std::vector<InterfacePiece>*>& pieces)
{
  std::map<UnorderedPair, std::size_t> corners;
  for (const std::vector<InterfacePiece>* list : pieces)
  {
    for (const InterfacePiece& piece : *list)
    {
      corners[piece.materials] += piece.corners.size();
    }
  }
  std::map<UnorderedPair, Triangles> triangles;
  for (const auto& [materials, count] : corners)
  {
    triangles[materials].reserve(count);
  }
  for (const std::vector<InterfacePiece>* list : pieces)
  {
    for (const InterfacePiece& piece : *list)
    {
      Triangles& all = triangles[piece.materials];
      for (std::size_t i = 1; i + 1 < piece.corners.size(); ++i)
      {
        all.push_back({ piece.corners[0], piece.corners[i], piece.corners[i + 1] });
      }
    }
  }
  makeTrees(std::move(triangles));
}

void InterfaceTrees::makeTrees(std::map<UnorderedPair, Triangles> triangles)
{
  for (auto& [materials, list] : triangles)
  {
    trees_[materials] = std::make_unique<TriangleTree>(std::move(list));
  }
}

const TriangleTree* InterfaceTrees::between(UnorderedPair materials) const
{
  const auto found = trees_.find(materials);
  return found == trees_.end() || found->second->empty() ? nullptr : found->second.get();
}

RegionTrees::RegionTrees(const InterfaceTrees& interfaces)
{
  std::map<MaterialId, std::vector<std::array<Vector, 3>>> triangles;
  for (const auto& [materials, tree] : interfaces.all())
  {
    for (const MaterialId material : { materials.lower, materials.upper })
    {
      triangles[material].insert(triangles[material].end(), tree->triangles().begin(), tree->triangles().end());
    }
  }
  for (auto& [material, list] : triangles)
  {
    trees_[material] = std::make_unique<TriangleTree>(std::move(list));
  }
}

const TriangleTree* RegionTrees::around(MaterialId material) const
{
  const auto found = trees_.find(material);
  return found == trees_.end() || found->second->empty() ? nullptr : found->second.get();
}
}
