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
  /// Starts with the base mesh. A front that is not `resumable` comes to its end at one scale, and is quicker.
  Front(const Hierarchy& hierarchy, bool resumable);

  /// Splits cells as the criterion asks, as far as the hierarchy has been built, and stops beyond a number of
  /// cells. The criterion must be the same each time; the scale must not grow. Returns the diamonds that have to be
  /// built before it can go on: none when it is done.
  std::vector<DiamondId> advance(
    const Hierarchy& hierarchy, const Criterion& criterion, double scale, Index maximumNumberOfCells);

  /// Splits the given cells of the mesh, and what conformity needs besides; `advance` looks at their children.
  /// Returns the diamonds that have to be built before it can be called again with the same cells: none when
  /// it is done.
  std::vector<DiamondId> split(const Hierarchy& hierarchy, const std::vector<CellId>& cells);

  Index cellCount() const { return cellCount_; }
  /// Whether no cell of the mesh exceeds the criterion's bounds; for a resumable front that has been advanced to its
  /// end.
  bool meetsBounds(const Hierarchy& hierarchy) const;
  Level level(const Hierarchy& hierarchy) const;

private:
  /// A cell that need not be split at the scales so far, and the scale below which it must.
  struct RestingCell
  {
    CellId cell;
    float ratio;
  };
  class CellStack;
  /// What visits of cells find.
  struct Findings
  {
    std::vector<DiamondId> tooCoarse;
    std::vector<CellId> waiting;
    std::vector<RestingCell> resting;
  };

  bool isActive(DiamondId id) const { return active_[static_cast<std::size_t>(id.value)] == active; }
  /// Visits cells of the mesh and, below those that must be split, all others, in parallel. Each cell is visited once:
  /// cells that are split for conformity alone end a visit, and their children begin another.
  void visit(const Hierarchy& hierarchy, const Criterion& criterion, double scale, std::vector<CellId> cells);
  /// Goes down from a few cells until they are enough for all threads.
  std::vector<CellId> spread(
    const Hierarchy& hierarchy, const Criterion& criterion, double scale, std::vector<CellId> cells);
  void visitBelow(const Hierarchy& hierarchy, const Criterion& criterion, double scale, const CellId* tops,
    std::size_t count, Findings& found) const;
  /// Looks at the top of a stack, and puts its children there if they have to be looked at.
  void look(
    const Hierarchy& hierarchy, const Criterion& criterion, double scale, CellStack& stack, Findings& found) const;
  /// Splits the diamonds that were found too coarse. Returns the children of cells split for conformity alone.
  std::vector<CellId> splitTooCoarse(const Hierarchy& hierarchy, const Criterion& criterion, double scale);
  /// Takes resting cells up again that are too coarse at a smaller scale; forgets those that have been split.
  std::vector<CellId> wake(const Hierarchy& hierarchy, const Criterion& criterion, double scale);
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
  std::vector<DiamondId> tooCoarse_; ///< diamonds to be split
  std::vector<DiamondId> splitLast_; ///< diamonds that have just been split
  std::vector<CellId> waiting_;      ///< cells to be looked at next: their diamonds have to be built before, or are new
  std::vector<RestingCell> resting_; ///< some of them split since
  std::vector<DiamondId> missing_;
  bool resumable_;
  bool begun_ = false; ///< whether the base mesh has been looked at
  Index cellCount_ = 0;
};
}
