#pragma once

#include "Geometry/CutTetrahedron.h"
#include "Model/Representation.h"

#include <array>
#include <vector>

namespace strata
{
/// The convex regions into which a cell's materials divide it. A workspace: `divide` replaces the former cell.
/// One object per thread.
class CellRegions
{
public:
  /// A convex polygon between two materials inside the cell; its normal points into `above`.
  struct Border
  {
    MaterialId below;
    MaterialId above;
    std::vector<Vector> corners;
  };
  /// A material's part of the cell's face opposite to the given corner (0 to 3).
  struct FacePart
  {
    int opposite = 0;
    MaterialId material;
    std::vector<Vector> corners;
  };

  explicit CellRegions(const Representation& representation) : representation_(representation) {}

  /// Divides a cell. Throws InvalidInput if it holds no material.
  void divide(Index cell);

  /// The cell's volume.
  double cellVolume() const { return cellVolume_; }
  /// The materials that have a region; they may have no volume where interfaces touch the cell's faces.
  MaterialSet materials() const { return regions_; }
  /// Volume of a material's region.
  double volume(MaterialId m) const;
  /// Integral of a scalar, linear in the cell and given by a value per vertex of the mesh, over a material's region.
  double integral(MaterialId m, const float* vertexValues) const;

  std::vector<Border> borders() const;
  std::vector<FacePart> faceParts() const;

private:
  using Barycentric = std::array<double, 4>;

  template<class Add>
  void forEachTetrahedron(MaterialId m, Add&& add) const;
  Vector position(int point) const;
  std::vector<Vector> corners(const TetrahedronCut::Face& face) const;

  const Representation& representation_;
  Index cell_ = -1;
  double cellVolume_ = 0.0;
  MaterialSet regions_;
  bool divided_ = false; ///< false: one material fills the cell, and the cut is not used
  TetrahedronCut cut_;
  std::vector<CornerValues> functions_;
};
}
