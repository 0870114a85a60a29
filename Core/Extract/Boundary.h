#pragma once

#include "Extract/GridTopology.h"
#include "Geometry/Box.h"
#include "Model/Materials.h"
#include "Model/Progress.h"

#include <optional>

namespace strata
{
/// The space that the visible cells leave in the data's box. Where it is a material, the faces towards it are
/// interfaces; faces in the sides of the box are the domain's boundary.
class Boundary
{
public:
  Boundary(const GridTopology& topology, const Materials& materials, const Box& box);

  /// The material named `outside`, if there is one.
  std::optional<std::uint8_t> outside() const { return outside_; }
  /// Whether face f of a cell is an interface to the outside.
  bool facesOutside(const CellFaces& faces, std::int32_t f) const;
  /// Flags the cells that have such a face; empty if there is no outside.
  std::vector<std::uint8_t> cellsAtOutside(Progress& progress) const;
  /// Whether all corners of a face lie in one side of the box, up to rounding.
  bool inSideOfBox(const std::vector<Vector>& corners) const;

private:
  const GridTopology& topology_;
  Box box_;
  std::optional<std::uint8_t> outside_;
};
}
