#pragma once

#include "Extract/CellComplex.h"
#include "Extract/MaterialValues.h"

#include <vector>

namespace strata
{
/// The values of the materials that may win in a cell of a complex, gathered at its vertices. A workspace.
///
/// Row 0 is the cell's centre. The rows of a face are its centre and then its corners, in the face's order.
class CellTable
{
public:
  CellTable(const CellComplex& complex, const MaterialValues& values) : complex_(complex), values_(values) {}

  /// Gathers a cell. What one other material beats at every vertex wins nowhere and is left out.
  void gather(std::int32_t cell);

  /// The materials that are left, ascending.
  const std::vector<std::uint8_t>& materials() const { return materials_; }
  int count() const { return static_cast<int>(materials_.size()); }
  /// The values of a row, by position in `materials`.
  const double* row(int r) const { return rows_.data() + static_cast<std::size_t>(r) * materials_.size(); }
  std::int32_t vertex(int row) const { return vertices_[static_cast<std::size_t>(row)]; }

  /// Calls visit(volume, face row, first corner's row, second corner's row) for the cell's tetrahedra with row 0,
  /// positively oriented.
  template<typename Visit>
  void forEachTetrahedron(const Visit& visit) const
  {
    for (const Tetrahedron& t : tetrahedra_)
    {
      visit(t.volume, t.face, t.first, t.second);
    }
  }

private:
  struct Tetrahedron
  {
    double volume;
    int face;
    int first;
    int second;
  };

  void listTetrahedra(std::int32_t cell);
  void listMaterials();
  void leaveOutBeaten();

  const CellComplex& complex_;
  const MaterialValues& values_;
  std::vector<std::int32_t> vertices_; ///< by row
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<std::uint8_t> materials_;
  std::vector<double> rows_;
};
}
