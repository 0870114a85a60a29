#pragma once

#include "Geometry/CutPoints.h"

#include <vector>

namespace strata
{
/// A convex polyhedron known by the names of its vertices alone. Three faces meet in each vertex.
class SymbolicPolyhedron
{
public:
  struct Face
  {
    int label = 0; ///< the function beyond, or -1 - c opposite to corner c
    int begin = 0; ///< loop of vertices, counter-clockwise seen from outside
    int end = 0;
  };

  /// Becomes the whole tetrahedron with positively oriented corners 0, 1, 2, 3.
  void reset();
  /// Keeps what lies on the positive side of a plane: `signs` has +1 or -1 for each vertex.
  void clip(int function, const std::vector<int>& signs);

  bool empty() const { return faces_.empty(); }
  const std::vector<SymbolicVertex>& vertices() const { return vertices_; }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<int>& loops() const { return loops_; }

private:
  struct Crossing
  {
    int from; ///< end points before the clip, from < to
    int to;
    int vertex;   ///< new vertex
    int next = 0; ///< the crossing that follows in the new face
  };

  int crossing(int a, int b, int function);
  void clipFace(const Face& face, int function, const std::vector<int>& signs);
  void addNewFace(int function);

  std::vector<SymbolicVertex> vertices_, clippedVertices_;
  std::vector<Face> faces_, clippedFaces_;
  std::vector<int> loops_, clippedLoops_;
  std::vector<int> kept_; ///< new position of each old vertex, or -1
  std::vector<Crossing> crossings_;
};
}
