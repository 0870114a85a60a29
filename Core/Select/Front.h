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
  /// cells. The criterion must be the same each time; the scale must not grow. Returns the diamonds that have to be
  /// built before it can go on: none when it is done.
  std::vector<DiamondId> advance(
    const Hierarchy& hierarchy, const Criterion& criterion, double scale, Index maximumNumberOfCells);

  /// Splits the given cells of the mesh, and what conformity needs besides; their children are not looked at.
  /// Returns the diamonds that have to be built before it can be called again with the same cells: none when
  /// it is done.
  std::vector<DiamondId> split(const Hierarchy& hierarchy, const std::vector<CellId>& cells);

  Index cellCount() const { return cellCount_; }
  /// Whether no cell of the mesh exceeds the criterion's bounds; for a front that has been advanced to its end.
  bool meetsBounds(const Hierarchy& hierarchy) const;
  Level level(const Hierarchy& hierarchy) const;

private:
  /// A cell that need not be split at the scales so far, and the scale below which it must.
  struct RestingCell
  {
    CellId cell;
    float ratio;
  };
  /// What a look at some cells finds.
  struct Findings
  {
    std::vector<RestingCell> resting;
    std::vector<CellId> tooCoarse;
    Index cellCount = 0; ///< cells that were split
  };

  bool isActive(DiamondId id) const { return active_[static_cast<std::size_t>(id.value)] == active; }
  /// Looks at a cell of the mesh unless its diamond has been split.
  void look(const Hierarchy& hierarchy, const Criterion& criterion, double scale, CellId cell, Findings& found) const;
  /// Looks at the children of all cells of the diamonds that were split last.
  void lookAtChildren(const Hierarchy& hierarchy, const Criterion& criterion, double scale);
  void keep(const std::vector<Findings>& blocks);
  /// Takes resting cells up again that are too coarse at a smaller scale; forgets those that have been split.
  void wake(const Hierarchy& hierarchy, const Criterion& criterion, double scale);
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
  std::vector<DiamondId> splitLast_; ///< active diamonds whose cells' children have not been looked at
  std::vector<CellId> tooCoarse_;    ///< cells to be split
  std::vector<CellId> waiting_;      ///< cells to be split whose diamonds wait for missing ones
  std::vector<RestingCell> resting_; ///< some of them split since
  std::vector<DiamondId> missing_;
  bool begun_ = false; ///< whether the base mesh has been looked at
  Index cellCount_ = 0;
};
}
