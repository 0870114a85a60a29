#pragma once

#include "Extract/CellComplex.h"
#include "Extract/MaterialValues.h"
#include "Extract/Patches.h"
#include "Geometry/CutVolumes.h"

#include <vector>

namespace strata
{
/// Cuts the cells of a complex among the materials that compete in them. A workspace: one per thread.
class CellCutter
{
public:
  /// `winners`: the winning material at each vertex, as MaterialValues::winner says.
  CellCutter(const CellComplex& complex, const MaterialValues& values, const std::vector<std::uint8_t>& winners) :
    complex_(complex), values_(values), winners_(winners)
  {}

  static constexpr std::uint8_t several = 255;
  /// The material that wins at every vertex of a cell, and so fills it, or `several`.
  std::uint8_t only(std::int32_t cell) const;

  /// Regions of a cell by material, in the order they are met.
  struct Regions
  {
    std::vector<std::uint8_t> materials;
    std::vector<double> volumes;
    /// [i * 64 + j]: how volume i changes when material j's values rise by a constant.
    std::vector<double> derivatives;
    double total = 0.0; ///< volume of the cell

    std::size_t of(std::uint8_t material);
    void clear();
  };
  void volumes(std::int32_t cell, Regions& regions);

  /// Adds the interfaces in a cell, and those between its materials and `outside` on its faces that are flagged in
  /// `facesOutside` (may be empty).
  void addInterfaces(
    std::int32_t cell, const std::vector<std::uint8_t>& facesOutside, std::uint8_t outside, SurfacePatch& patch);

private:
  /// Collects the materials that may win in a tetrahedron. Returns false if there is only one.
  bool gather(const std::array<std::int32_t, 4>& vertices);
  void addPolygon(const TetrahedronCut::Face& face, std::uint8_t front, SurfacePatch& patch);
  void addTetrahedron(
    const std::array<std::int32_t, 4>& vertices, bool atOutside, std::uint8_t outside, SurfacePatch& patch);

  const CellComplex& complex_;
  const MaterialValues& values_;
  const std::vector<std::uint8_t>& winners_;
  TetrahedronCut cut_;
  std::vector<CornerValues> functions_;
  std::vector<std::int32_t> numbers_;
  std::vector<double> tetrahedronVolumes_;
  std::vector<double> tetrahedronDerivatives_;
};
}
