#pragma once

#include "Extract/CellTable.h"
#include "Extract/Patches.h"
#include "Geometry/CutVolumes.h"

#include <optional>
#include <vector>

namespace strata
{
/// Cuts the cells of a complex among the materials that compete in them. A workspace: one per thread.
class CellCutter
{
public:
  /// `winners`: the winning material at each vertex, as MaterialValues::winner says.
  CellCutter(const CellComplex& complex, const MaterialValues& values, const std::vector<std::uint8_t>& winners) :
    complex_(complex), winners_(winners), table_(complex, values)
  {}

  static constexpr std::uint8_t several = 255;
  /// The material that wins at every vertex of a cell, and so fills it, or `several`.
  std::uint8_t only(std::int32_t cell) const;

  /// Regions of a cell by material.
  struct Regions
  {
    std::vector<std::uint8_t> materials; ///< ascending; some may have no region
    std::vector<double> volumes;
    /// [i * materials + j]: how volume i changes when material j's values rise by a constant.
    std::vector<double> derivatives;
    double total = 0.0; ///< volume of the cell
  };
  /// Where values rise.
  enum class Rise
  {
    Everywhere,
    Centre
  };
  void volumes(std::int32_t cell, Regions& regions, Rise rise = Rise::Everywhere);

  /// Adds the interfaces in a cell, and those between its materials and `outside` on its faces that are flagged in
  /// `facesOutside` (may be empty).
  void addInterfaces(
    std::int32_t cell, const std::vector<std::uint8_t>& facesOutside, std::uint8_t outside, SurfacePatch& patch);

private:
  /// Collects the materials that may win between four rows of the table. Returns false if there is only one.
  bool compete(const std::array<int, 4>& rows);
  /// Adds what the tetrahedra hold, if two materials share the cell.
  void halve(Regions& regions) const;
  void share(Regions& regions, Rise rise);
  void addPolygon(const TetrahedronCut::Face& face, std::uint8_t front, SurfacePatch& patch);
  /// `outside`: the material beyond the side opposite to the first vertex, if that is an interface to it.
  void addTetrahedron(const std::array<std::int32_t, 4>& vertices, const std::array<int, 4>& rows,
    std::optional<std::uint8_t> outside, SurfacePatch& patch);

  const CellComplex& complex_;
  const std::vector<std::uint8_t>& winners_;
  CellTable table_;
  TetrahedronCut cut_;
  std::vector<int> slots_; ///< position in the table's materials by function
  std::vector<CornerValues> functions_;
  std::vector<std::int32_t> numbers_;
  std::vector<double> tetrahedronVolumes_;
  std::vector<double> tetrahedronDerivatives_;
};
}
