#pragma once

#include "Extract/GridTopology.h"
#include "Model/Progress.h"

#include <utility>
#include <vector>

namespace strata
{
/// A face of one cell that no other cell has.
struct UnmatchedFace
{
  Index cell;
  std::int32_t face;
};

/// How far from an edge or a face a point may lie and still count as hanging on it: part of the edge's or face's size.
constexpr double hangingTolerance = 1e-6;

/// The edges of unmatched faces on which points of other such faces hang.
///
/// No other edge has any: where all faces round an edge are matched, cells with that edge fill the space around it.
class SplitEdges
{
public:
  using Edge = std::pair<Index, Index>; ///< ascending point ids

  SplitEdges(const GridTopology& topology, const std::vector<UnmatchedFace>& faces, Progress& progress);

  const std::vector<Edge>& edges() const { return edges_; }
  /// The corners of a face together with the points that hang on its edges, in cyclic order.
  std::vector<Index> withHangingPoints(const std::vector<Index>& corners) const;

private:
  const std::vector<Index>* pointsOf(Index a, Index b) const;

  std::vector<Edge> edges_;                ///< ascending
  std::vector<std::vector<Index>> points_; ///< by edge: from its first end to its second
};
}
