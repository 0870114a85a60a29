#pragma once

#include "Build/BuildOptions.h"
#include "Build/SurfaceEdges.h"
#include "Geometry/TriangleTree.h"
#include "Geometry/WindingNumber.h"
#include "Model/Interfaces.h"

#include <bitset>
#include <memory>

namespace strata
{
/// Where a point lies with respect to a material's region.
struct RegionPoint
{
  bool inside = false;
  double distance = 0.0; ///< to the region; 0 inside
  Vector closest;        ///< the region's closest point; the point itself inside
};

/// The closed surface round one material's region, oriented outwards, ready for distance queries. Where the
/// region ends at the box, the surface is open there, and the box closes it.
class RegionBoundary
{
public:
  /// `fillsBox`: what the region is when no interface bounds it: all of the box, or nothing.
  RegionBoundary(
    const Interfaces& interfaces, MaterialId material, const Box& box, DistanceMethod method, bool fillsBox);

  /// Exact distance (or, by the paper's rule, distance to the closest vertex); the side follows from the
  /// angle-weighted pseudonormal of the closest feature (Baerentzen and Aanaes 2005), or from the winding number where
  /// the surface is open there. Thread-safe.
  RegionPoint locate(const Vector& point) const;

private:
  /// Pseudonormals of a triangle's features, indexed by TriangleFeature.
  using FeatureNormals = std::array<Vector, 7>;

  /// Which of them lie where the surface is open within the box.
  using OpenFeatures = std::bitset<7>;

  void makeNormals(const std::vector<Vector>& points, const std::vector<SurfaceTriangle>& triangles);
  void findOpenFeatures(const std::vector<Vector>& points, const std::vector<SurfaceTriangle>& triangles);
  void makeTree(
    const std::vector<Vector>& points, const std::vector<SurfaceTriangle>& triangles, DistanceMethod method);
  void makeWinding(const std::vector<Vector>& points, const std::vector<SurfaceTriangle>& triangles);

  bool isOpen(const TriangleTree::Hit& hit) const;
  bool isBehind(const TriangleTree::Hit& hit, const Vector& point) const;

  Box box_;
  bool fillsBox_ = false;
  std::unique_ptr<TriangleTree> tree_;
  std::vector<FeatureNormals> normals_;
  std::vector<OpenFeatures> open_;         ///< of each triangle; empty for a closed surface
  std::unique_ptr<WindingNumber> winding_; ///< null for a closed surface
};
}
