#pragma once

#include "Geometry/CutPoints.h"
#include "Geometry/SymbolicPolyhedron.h"

#include <array>
#include <cstdint>
#include <vector>

namespace strata
{
/// A tetrahedron cut into the convex regions where each of several linear functions is the smallest
/// (design 3.8). Ties go to the lowest id: function m counts as lowered by an infinitesimal e^(m+1). Every
/// decision is the exact sign of a determinant of corner values, so tetrahedra that share a face cut it
/// in the same way, point for point. Points that coincide exactly are one point.
///
/// The object is a workspace: `cut` replaces the former result. One object per thread.
class TetrahedronCut
{
public:
  /// A face of a region: a convex polygon, its points counter-clockwise seen from outside the region
  /// (for a tetrahedron whose corners are given in positive orientation).
  struct Face
  {
    int function = 0; ///< whose region
    /// The function beyond, or -1 - c on the tetrahedron's face opposite to the given corner c.
    int beyond = 0;
    int begin = 0; ///< points: loops()[begin] .. loops()[end]
    int end = 0;

    /// True for one of the two sides of an interface: the one of the lower function, whose normal points into
    /// the higher one.
    bool isInterface() const { return beyond > function; }
  };

  /// Cuts. `vertices` are the corners' global ids, all different; the functions' ids ascend.
  void cut(const std::array<std::int64_t, 4>& vertices, const CornerValues* functions, int count);

  /// The functions that have a region, by ascending id.
  const std::vector<int>& winners() const { return winners_; }
  /// The faces of all regions, grouped by function, ascending. Each interface appears twice, once for either side.
  /// A region may have no volume: a lens between two equal faces where functions tie on a whole face.
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<int>& loops() const { return loops_; }
  /// Every point once.
  const std::vector<CutPoint>& points() const { return points_.points(); }
  /// Barycentric coordinates of each point with respect to the corners by ascending id.
  const std::vector<std::array<double, 4>>& coordinates() const { return points_.coordinates(); }
  /// The corners by ascending id.
  const std::array<std::int64_t, 4>& sortedVertices() const { return points_.sortedVertices(); }
  /// True where putting the corners into ascending order turns the orientation round.
  bool reversed() const { return points_.reversed(); }

private:
  void addRegion(int function);
  void addFace(int function, const SymbolicPolyhedron::Face& face);

  CutPoints points_;
  SymbolicPolyhedron region_;
  std::vector<int> signs_;         ///< of a function at the region's vertices
  std::vector<int> pointOfVertex_; ///< of the region
  std::vector<int> loop_;
  std::vector<int> winners_;
  std::vector<Face> faces_;
  std::vector<int> loops_;
};
}
