#pragma once

#include "Geometry/Box.h"
#include "Geometry/TriangleTree.h"
#include "Model/Interfaces.h"

#include <utility>
#include <vector>

namespace strata
{
/// Tells on which side of the original interfaces a point lies: in the material on the near side of the closest
/// interface triangle. Where the closest point is on an edge, the one of its triangles decides that faces the point
/// most squarely: all of them lead away from the point, and of those that bound its material's wedge, one leads away
/// least. Where it is a corner, this holds for the triangles at the corner's edge that leads away from the point least.
class OriginalMaterial
{
public:
  struct Answer
  {
    MaterialId material;
    double distance = 0.0; ///< to the closest interface: within it, the material is the same everywhere but near gaps
    /// The closest point is on an edge at which the interfaces end within the box: they leave the side open, and the
    /// answer is that of the interface continued.
    bool nearGap = false;
  };

  /// `withoutInterfaces` is the answer where there are no interfaces at all. The interfaces must outlive the object.
  OriginalMaterial(const Interfaces& interfaces, const Box& box, MaterialId withoutInterfaces);

  bool hasGaps() const { return !rims_.empty(); }

  Answer at(const Vector& p) const;

  /// A ball that no interface meets. None at first.
  struct Ball
  {
    Vector center = Vector::Zero();
    Answer answer{ {}, -1.0 }; ///< its material and radius
  };
  /// As `at`, but the distance may be too small, though not below `needed` unless the true one is. Saves the query
  /// where the last ball tells enough and the interfaces have no gaps; otherwise replaces it.
  Answer at(const Vector& p, double needed, Ball& last) const;

private:
  struct Side
  {
    MaterialId positive;
    MaterialId negative;
    std::array<std::int32_t, 3> corners; ///< points of the interfaces
  };

  std::int32_t edgeTowards(std::int32_t corner, const Vector& direction) const;
  MaterialId sideOf(const Vector& offset, std::int32_t corner, std::int32_t otherCorner) const;
  MaterialId sideOf(const Vector& offset, const TriangleTree::Hit& hit) const;
  Vector normal(std::int32_t triangle) const;
  void findRims(const Box& box);
  bool isNearGap(const TriangleTree::Hit& hit) const;

  const Interfaces& interfaces_;
  MaterialId withoutInterfaces_;
  std::vector<Side> sides_; ///< of the tree's triangles
  /// Triangles round interface point i: around_[aroundStart_[i]] .. around_[aroundStart_[i + 1]].
  std::vector<std::int32_t> around_;
  std::vector<std::int32_t> aroundStart_;
  /// Edges where the interfaces end within the box, by their points, the lower first; sorted.
  std::vector<std::pair<std::int32_t, std::int32_t>> rims_;
  std::vector<std::uint8_t> isOnRim_; ///< of each point
  TriangleTree tree_;
};
}
