#pragma once

#include "Geometry/CutPoints.h"

#include <array>
#include <cstdint>
#include <vector>

namespace strata
{
/// A triangle, or the section of a tetrahedron with a plane, cut into the convex polygons where each of several
/// linear functions is the smallest. The same rules, names and points as in TetrahedronCut: a triangle is cut as the
/// tetrahedra on its sides cut it, and the polygons of a section fit together across the tetrahedra.
///
/// The object is a workspace: a cut replaces the former result. One object per thread.
class PolygonCut
{
public:
  struct Region
  {
    int function = 0;
    int begin = 0; ///< points: loops()[begin] .. loops()[end]
    int end = 0;
  };

  /// Cuts a triangle; the functions' fourth value is not used. Polygons have its orientation.
  void cutTriangle(const std::array<std::int64_t, 3>& vertices, const CornerValues* functions, int count);
  /// Cuts the section with the plane where the linear function of the given corner values is 0; a value of 0 counts as
  /// positive. Polygons are counter-clockwise seen from the positive side of a positively oriented tetrahedron. Points
  /// on an edge are named by the edge alone; others by the functions that tie there, two in a face, three inside.
  void cutSection(const std::array<std::int64_t, 4>& vertices, const std::array<double, 4>& planeValues,
    const CornerValues* functions, int count);

  /// The regions by ascending function.
  const std::vector<Region>& regions() const { return regions_; }
  const std::vector<int>& loops() const { return loops_; }
  const std::vector<CutPoint>& points() const { return points_.points(); }

private:
  void startSection(const std::array<double, 4>& planeValues);
  void addRegions();
  void clip(int function);

  CutPoints points_;
  std::vector<SymbolicVertex> whole_; ///< the polygon before the cut
  std::vector<SymbolicVertex> region_, clipped_;
  std::vector<int> signs_;
  std::vector<int> loop_;
  std::vector<Region> regions_;
  std::vector<int> loops_;
};
}
