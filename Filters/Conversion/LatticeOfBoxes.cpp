#include "Conversion/LatticeOfBoxes.h"

#include "Conversion/Weld.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace strata::conversion
{
namespace
{
constexpr Index nothing = -1;

/// A rectilinear grid, and which cell and point of the unstructured one each of its cells and points is.
struct Lattice
{
  RectilinearGrid grid;
  std::vector<Index> cells;
  std::vector<Index> points;
};

std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

Box boxOf(const UnstructuredGrid& grid, Index cell)
{
  Box box;
  for (Index k = grid.cornerOffsets[at(cell)]; k < grid.cornerOffsets[at(cell) + 1]; ++k)
  {
    box.add(grid.points[at(grid.corners[at(k)])]);
  }
  return box;
}

/// Whether all corners of a hexahedron are corners of its box.
bool isBox(const UnstructuredGrid& grid, Index cell, double tolerance)
{
  if (grid.shapes[at(cell)] != CellShape::Hexahedron)
  {
    return false;
  }
  const Box box = boxOf(grid, cell);
  unsigned int found = 0;
  for (Index k = grid.cornerOffsets[at(cell)]; k < grid.cornerOffsets[at(cell) + 1]; ++k)
  {
    const Vector& point = grid.points[at(grid.corners[at(k)])];
    const Vector fromUpper = box.upper - point;
    if (!((point - box.lower).cwiseMin(fromUpper).maxCoeff() <= tolerance))
    {
      return false;
    }
    const auto upper = (fromUpper.array() <= tolerance).cast<unsigned int>();
    found |= 1u << (upper[0] + 2 * upper[1] + 4 * upper[2]);
  }
  return found == 255u;
}

/// The distinct ones of the points' coordinates along an axis, ascending.
std::vector<double> coordinatesAlong(int axis, const std::vector<Vector>& points, double tolerance)
{
  std::vector<double> result(points.size());
  std::transform(points.begin(), points.end(), result.begin(), [&](const Vector& point) { return point[axis]; });
  std::sort(result.begin(), result.end());
  const auto same = [&](double a, double b) { return b - a <= tolerance; };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

/// The number of a coordinate in a list that has it within the tolerance.
Index numberOf(const std::vector<double>& coordinates, double x, double tolerance)
{
  return std::upper_bound(coordinates.begin(), coordinates.end(), x + tolerance) - coordinates.begin() - 1;
}

class LatticeBuilder
{
public:
  LatticeBuilder(const UnstructuredGrid& grid, double tolerance) : grid_(grid), tolerance_(tolerance) {}

  std::optional<Lattice> build()
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      lattice_.grid.coordinates[axis] = coordinatesAlong(static_cast<int>(axis), grid_.points, tolerance_);
    }
    if (lattice_.grid.cellCount() != grid_.cellCount() || lattice_.grid.pointCount() != grid_.pointCount())
    {
      return std::nullopt;
    }
    lattice_.cells.assign(at(grid_.cellCount()), nothing);
    lattice_.points.assign(at(grid_.pointCount()), nothing);
    for (Index cell = 0; cell < grid_.cellCount(); ++cell)
    {
      if (!place(cell))
      {
        return std::nullopt;
      }
    }
    return std::move(lattice_);
  }

private:
  using Position = std::array<Index, 3>;

  Position positionOf(const Vector& point) const
  {
    const auto& axes = lattice_.grid.coordinates;
    return { numberOf(axes[0], point[0], tolerance_), numberOf(axes[1], point[1], tolerance_),
      numberOf(axes[2], point[2], tolerance_) };
  }

  /// Gives a cell and its points their places; false if they are taken, or if the cell reaches over several.
  bool place(Index cell)
  {
    const Box box = boxOf(grid_, cell);
    const Position lower = positionOf(box.lower);
    const Position upper = positionOf(box.upper);
    bool one = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      one = one && upper[axis] == lower[axis] + 1;
    }
    const RectilinearGrid& grid = lattice_.grid;
    if (!one || !take(lattice_.cells, lower[0] + grid.cellCount(0) * (lower[1] + grid.cellCount(1) * lower[2]), cell))
    {
      return false;
    }
    for (Index k = grid_.cornerOffsets[at(cell)]; k < grid_.cornerOffsets[at(cell) + 1]; ++k)
    {
      const Index point = grid_.corners[at(k)];
      const Position p = positionOf(grid_.points[at(point)]);
      if (!take(lattice_.points, p[0] + grid.pointCount(0) * (p[1] + grid.pointCount(1) * p[2]), point))
      {
        return false;
      }
    }
    return true;
  }

  static bool take(std::vector<Index>& places, Index place, Index owner)
  {
    const bool isFree = places[at(place)] == nothing;
    places[at(place)] = isFree ? owner : places[at(place)];
    return places[at(place)] == owner;
  }

  const UnstructuredGrid& grid_;
  double tolerance_;
  Lattice lattice_;
};

/// What the numbers of the places' owners come from; nothing where all places are their own sources.
std::vector<Index> sourcesOf(const std::vector<Index>& owners, const std::vector<Index>& sources, bool oneBlock)
{
  std::vector<Index> result(owners.size());
  bool own = oneBlock;
  for (std::size_t i = 0; i < owners.size(); ++i)
  {
    result[i] = sources[at(owners[i])];
    own = own && result[i] == static_cast<Index>(i);
  }
  return own ? std::vector<Index>{} : result;
}
}

void recognizeLattice(InputGrid& input)
{
  if (!input.curved.empty())
  {
    return;
  }
  const auto& grid = std::get<UnstructuredGrid>(input.grid);
  const double tolerance = weldTolerance * bounds(input.grid).diagonal();
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    if (!isBox(grid, cell, tolerance))
    {
      return;
    }
  }
  std::optional<Lattice> lattice = LatticeBuilder(grid, tolerance).build();
  if (lattice)
  {
    const InputBlock& block = input.blocks.front();
    const bool one = input.blocks.size() == 1;
    input.cellSource = sourcesOf(lattice->cells, input.cellSource, one && block.cellCount == lattice->grid.cellCount());
    input.pointSource =
      sourcesOf(lattice->points, input.pointSource, one && block.pointCount == lattice->grid.pointCount());
    input.grid = std::move(lattice->grid);
  }
}
}
