#pragma once

#include "Geometry/Vector.h"
#include "Model/Grid.h"

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

class vtkUnstructuredGrid;

namespace strata::conversion
{
/// How much each node of a curved cell counts at a place in it.
using NodeWeights = std::vector<std::pair<int, double>>;

/// How a quadratic, Lagrange or Bezier cell becomes linear ones: the points of a regular lattice in it, which are its
/// own nodes wherever it has one there, and the pieces between them. Cells of one type and degree share a pattern, and
/// those that share a face cut it alike.
struct CurvedPattern
{
  struct Piece
  {
    CellShape shape = CellShape::Hexahedron;
    std::vector<int> corners; ///< positions in `points`
  };

  int nodeCount = 0;
  std::vector<NodeWeights> points;
  std::vector<Piece> pieces;
  /// The points of `points` in the straight cell between the corners: weights of its first nodes.
  std::vector<NodeWeights> straight;
  /// Weights of the nodes in the Bernstein coefficients of the cell's function minus the piece's, for one piece after
  /// the other: (deviationDegree + 1)^3 of a cube of which the piece is a (maybe collapsed) image, the first axis
  /// fastest. Empty where the functions are no polynomials: pyramids, Bezier cells with rational weights.
  int deviationDegree = 0;
  std::vector<NodeWeights> deviation;
};

/// The patterns of a data set's curved cells, made when first asked for.
class CurvedPatterns
{
public:
  explicit CurvedPatterns(vtkUnstructuredGrid* data);

  /// The pattern of a cell of a type with that many points; null if VTK has no functions for it.
  std::shared_ptr<const CurvedPattern> of(Index cell, int type, Index pointCount);

private:
  std::shared_ptr<const CurvedPattern> make(Index cell, int type, Index pointCount) const;

  vtkUnstructuredGrid* data_;
  bool rational_; ///< the points have weights
  bool degrees_;  ///< the cells have degrees of their own
  /// By type, number of points and, where cells differ in more than these, cell.
  std::map<std::tuple<int, Index, Index>, std::shared_ptr<const CurvedPattern>> patterns_;
};
}
