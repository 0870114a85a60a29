#pragma once

#include "Extract/CellVolumes.h"
#include "Extract/CellsAround.h"

#include <utility>
#include <vector>

namespace strata
{
/// Adds to a material's share, which joins the list if it isn't in it.
void addTo(std::vector<Share>& shares, std::uint8_t material, double value);

/// Passes volumes on to cells that an interface crosses. A workspace.
class PassOn
{
public:
  /// Both arguments must outlive it.
  PassOn(const CellsAround& around, const CellVolumes& volumes) :
    around_(around), volumes_(volumes), seen_(around.nodeStart.size() - 1, 0)
  {}

  /// Gives what a cell lacks (sum 0), pair by pair of materials, to the nearest cells, at most three rings away, in
  /// which the pair touches, in proportion to the area; where there are none it stays. The cell and its neighbours are
  /// the first ring.
  void give(std::int32_t cell, const std::vector<Share>& lacking, std::vector<std::vector<Share>>& received);

private:
  void find(std::int32_t cell, std::uint8_t a, std::uint8_t b);
  void take(std::int32_t cell, std::uint8_t a, std::uint8_t b);

  const CellsAround& around_;
  const CellVolumes& volumes_;
  std::vector<std::int32_t> seen_; ///< by cell: the last search that came across it
  std::int32_t search_ = 0;
  std::vector<std::int32_t> ring_, next_;
  std::vector<std::pair<std::int32_t, double>> cells_; ///< in which the pair touches, with half the areas
  double area_ = 0.0;                                  ///< the sum of them
};
}
