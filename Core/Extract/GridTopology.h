#pragma once

#include "Geometry/Vector.h"
#include "Model/Errors.h"
#include "Model/Grid.h"
#include "Model/Progress.h"

#include <memory>
#include <vector>

namespace strata
{
/// The faces of one cell. Face f has the corners corners[start[f]] .. corners[start[f + 1]], in cyclic order.
struct CellFaces
{
  std::vector<Index> corners;
  std::vector<std::int32_t> start{ 0 };
  /// The visible cell on the other side of each face; -1 where there is none.
  std::vector<Index> neighbours;

  std::int32_t count() const { return static_cast<std::int32_t>(neighbours.size()); }
  void clear()
  {
    corners.clear();
    start.assign(1, 0);
    neighbours.clear();
  }
};

/// Cells, faces and points of a native grid, asked one cell at a time so that nothing is stored per face.
/// Hidden cells take no part: they are nobody's neighbour. All functions may be called from several threads.
class GridTopology
{
public:
  virtual ~GridTopology() = default;

  virtual Index cellCount() const = 0;
  virtual Index pointCount() const = 0;
  virtual bool hidden(Index cell) const = 0;
  virtual Vector point(Index point) const = 0;
  /// The points of a cell's faces.
  virtual void corners(Index cell, std::vector<Index>& result) const = 0;
  /// The corner points whose mean is a cell's centre: without those that hang on its faces and edges.
  virtual void centerCorners(Index cell, std::vector<Index>& result) const { corners(cell, result); }
  virtual void faces(Index cell, CellFaces& result) const = 0;
  /// As `faces`, but the neighbours are not looked for.
  virtual void faceCorners(Index cell, CellFaces& result) const { faces(cell, result); }
  /// The visible cells that have a point as a corner, ascending.
  virtual void cellsAround(Index point, std::vector<Index>& result) const = 0;
  /// The mean of a cell's `centerCorners`.
  virtual Vector center(Index cell) const;
  /// Volume of the polyhedron bounded by the cell's faces, each a fan about its centre.
  virtual double volume(Index cell) const;
  /// What could not be used as the grid gives it.
  const Warnings& warnings() const { return warnings_; }

protected:
  Warnings warnings_;
};

/// The topology of a grid, which must outlive it. Cells with repeated corners become the polyhedra that they collapse
/// to, and cells that meet finer ones conform; cells that are no closed polyhedra are hidden.
std::unique_ptr<GridTopology> makeGridTopology(const Grid& grid, Progress& progress);
std::unique_ptr<GridTopology> makeGridTopology(const RectilinearGrid& grid, Progress& progress);
std::unique_ptr<GridTopology> makeGridTopology(const UnstructuredGrid& grid, Progress& progress);

/// Sum over a fan of triangles about a face's centre of six times the volume that each spans with `apex`.
/// Positive where the corners run counter-clockwise as seen from the side that is not the apex'.
double sixfoldVolume(const std::vector<Vector>& corners, const Vector& apex);
}
