#include "Extract/GridTopology.h"

#include <array>

namespace strata
{
namespace
{
class RectilinearGridTopology final : public GridTopology
{
public:
  explicit RectilinearGridTopology(const RectilinearGrid& grid) :
    grid_(grid), points_{ grid.pointCount(0), grid.pointCount(1), grid.pointCount(2) }, cells_{ grid.cellCount(0),
      grid.cellCount(1), grid.cellCount(2) }
  {}

  Index cellCount() const override { return grid_.cellCount(); }
  Index pointCount() const override { return grid_.pointCount(); }
  bool hidden(Index cell) const override
  {
    return !grid_.hidden.empty() && grid_.hidden[static_cast<std::size_t>(cell)] != 0;
  }

  Vector point(Index point) const override
  {
    const std::array<Index, 3> p = split(point, points_);
    return { coordinate(0, p[0]), coordinate(1, p[1]), coordinate(2, p[2]) };
  }

  void corners(Index cell, std::vector<Index>& result) const override
  {
    result.clear();
    const Index base = firstCorner(split(cell, cells_));
    for (int corner = 0; corner < 8; ++corner)
    {
      result.push_back(base + offset(corner));
    }
  }

  void faces(Index cell, CellFaces& result) const override
  {
    result.clear();
    const std::array<Index, 3> c = split(cell, cells_);
    const Index base = firstCorner(c);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        for (int corner : faceCorners_[2 * axis + side])
        {
          result.corners.push_back(base + offset(corner));
        }
        result.start.push_back(static_cast<std::int32_t>(result.corners.size()));
        result.neighbours.push_back(neighbour(c, axis, side));
      }
    }
  }

  void cellsAround(Index point, std::vector<Index>& result) const override
  {
    result.clear();
    const std::array<Index, 3> p = split(point, points_);
    for (Index k = p[2] - 1; k <= p[2]; ++k)
    {
      for (Index j = p[1] - 1; j <= p[1]; ++j)
      {
        for (Index i = p[0] - 1; i <= p[0]; ++i)
        {
          const bool inside = i >= 0 && j >= 0 && k >= 0 && i < cells_[0] && j < cells_[1] && k < cells_[2];
          if (inside && !hidden(cellIndex(i, j, k)))
          {
            result.push_back(cellIndex(i, j, k));
          }
        }
      }
    }
  }

  double volume(Index cell) const override
  {
    const std::array<Index, 3> c = split(cell, cells_);
    double product = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      product *= coordinate(axis, c[axis] + 1) - coordinate(axis, c[axis]);
    }
    return product;
  }

private:
  // Corner i + 2 j + 4 k; counter-clockwise as seen from outside.
  static constexpr int faceCorners_[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };

  static std::array<Index, 3> split(Index index, const std::array<Index, 3>& size)
  {
    const Index row = index / size[0];
    return { index - row * size[0], row % size[1], row / size[1] };
  }
  double coordinate(int axis, Index i) const { return grid_.coordinates[axis][static_cast<std::size_t>(i)]; }
  Index cellIndex(Index i, Index j, Index k) const { return i + cells_[0] * (j + cells_[1] * k); }
  Index firstCorner(const std::array<Index, 3>& c) const { return c[0] + points_[0] * (c[1] + points_[1] * c[2]); }
  Index offset(int corner) const
  {
    return (corner & 1) + points_[0] * (((corner >> 1) & 1) + points_[1] * ((corner >> 2) & 1));
  }
  Index neighbour(std::array<Index, 3> c, int axis, int side) const
  {
    c[axis] += side == 0 ? -1 : 1;
    if (c[axis] < 0 || c[axis] >= cells_[axis])
    {
      return -1;
    }
    const Index cell = cellIndex(c[0], c[1], c[2]);
    return hidden(cell) ? -1 : cell;
  }

  const RectilinearGrid& grid_;
  std::array<Index, 3> points_;
  std::array<Index, 3> cells_;
};
}

std::unique_ptr<GridTopology> makeGridTopology(const RectilinearGrid& grid, Progress&)
{
  return std::make_unique<RectilinearGridTopology>(grid);
}
}
