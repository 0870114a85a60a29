#pragma once

#include "Model/Level.h"
#include "Select/Criterion.h"

namespace strata
{
/// The mesh of a level while it grows from the base mesh downwards.
///
/// It is the smallest conforming mesh of the hierarchy in which no cell must be split. There is exactly one: a
/// cell of the mesh that must be split is, in any finer conforming mesh without such cells, split too. Hence
/// the order of work does not matter, and levels of tighter bounds refine those of looser ones.
class Front
{
public:
  /// Starts with the base mesh.
  explicit Front(const Hierarchy& hierarchy);

  /// Splits cells as the criterion asks, as far as the hierarchy has been built, and stops beyond a number of
  /// cells. Returns the diamonds that have to be built before it can go on: none when it is done.
  std::vector<DiamondId> advance(
    const Hierarchy& hierarchy, const Criterion& criterion, double scale, Index maximumNumberOfCells);

  /// Splits the given cells of the mesh, and what conformity needs besides; their children are not looked at.
  /// Returns the diamonds that have to be built before it can be called again with the same cells: none when
  /// it is done.
  std::vector<DiamondId> split(const Hierarchy& hierarchy, const std::vector<CellId>& cells);

  Index cellCount() const { return cellCount_; }
  /// Cells of the mesh (not in any order).
  const std::vector<CellId>& cells() const { return resting_; }
  Level level(const Hierarchy& hierarchy) const;

private:
  bool isActive(DiamondId id) const { return active_[static_cast<std::size_t>(id.value)] == active; }
  /// Splits a diamond in the mesh, its parents first; false if something has to be built before.
  bool activate(const Hierarchy& hierarchy, DiamondId id);
  bool activateParents(const Hierarchy& hierarchy, DiamondId id);
  /// For diamonds that are not built, whose parents may not even exist.
  bool activateParents(const Hierarchy& hierarchy, const LatticePoint& center);
  void forgetMissing(const Hierarchy& hierarchy);

  enum State : std::uint8_t
  {
    inactive,
    active,
    missing ///< asked for, but not built yet
  };

  std::vector<std::uint8_t> active_; ///< State of each diamond
  std::vector<CellId> pending_;      ///< cells to look at
  std::vector<CellId> resting_;      ///< cells that need not be split, some of them split since
  std::vector<CellId> waiting_;      ///< cells whose diamonds wait for missing ones
  std::vector<DiamondId> missing_;
  Index cellCount_ = 0;
};
}
