#pragma once

#include "Geometry/Vector.h"
#include "Model/Ids.h"

#include <array>
#include <vector>

namespace strata
{
/// The material interfaces of a data set as triangle meshes that share their points: along a junction
/// curve the meshes that meet use the same points.
struct Interfaces
{
  /// Triangles between one pair of materials. Counter-clockwise corners: the normal points into `positive`.
  struct Surface
  {
    MaterialId positive;
    MaterialId negative;
    std::vector<std::array<std::int32_t, 3>> triangles;
  };

  std::vector<Vector> points;
  std::vector<Surface> surfaces;

  Index triangleCount() const
  {
    Index count = 0;
    for (const Surface& surface : surfaces)
    {
      count += static_cast<Index>(surface.triangles.size());
    }
    return count;
  }
};
}
