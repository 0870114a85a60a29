#pragma once

#include "Model/NativeData.h"

#include <array>
#include <vector>

namespace strata
{
/// How distances to a material's region are found.
enum class DistanceMethod : std::uint8_t
{
  ClosestPoint, ///< exact closest point on the interface triangles
  ClosestVertex ///< closest vertex of the interface mesh: the paper's rule
};

/// What the native data elements are over which field errors are bounded.
enum class NativeElements : std::uint8_t
{
  Points, ///< native samples and interface vertices: the paper
  Cells   ///< whole native cells and interface triangles, certified
};

/// What a hierarchy is built from; a change of any of these builds anew.
struct BuildOptions
{
  std::array<int, 3> baseCubes = { 1, 1, 1 };
  /// Largest number of bisections below the base mesh.
  int maximumLevel = 60;
  DistanceMethod distanceMethod = DistanceMethod::ClosestPoint;
  GhostMethod ghostMethod = GhostMethod::DataThenLinear;
  NativeElements nativeElements = NativeElements::Points;
};
}
