#include "Conversion/CheckCells.h"

#include "Conversion/CellVolumes.h"

#include "Geometry/Box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace strata::conversion
{
namespace
{
/// Volumes below this part of the cell's box diagonal cubed are rounding errors.
constexpr double degenerateVolume = 1e-14;
/// Space in the box is none if it is below this part of the box and of the smallest cell: points may be floats.
constexpr double emptyPartOfBox = 1e-5;
constexpr double emptyPartOfCell = 0.1;

double sizeOf(const UnstructuredGrid& grid, Index cell)
{
  const auto c = static_cast<std::size_t>(cell);
  Box box;
  for (Index k = grid.cornerOffsets[c]; k < grid.cornerOffsets[c + 1]; ++k)
  {
    box.add(grid.points[static_cast<std::size_t>(grid.corners[static_cast<std::size_t>(k)])]);
  }
  return box.diagonal();
}
}

void orientWedges(UnstructuredGrid& grid)
{
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    if (grid.shapes[static_cast<std::size_t>(cell)] == CellShape::Wedge && cellVolume(grid, cell) < 0.0)
    {
      Index* corners = grid.corners.data() + grid.cornerOffsets[static_cast<std::size_t>(cell)];
      std::swap(corners[1], corners[2]);
      std::swap(corners[4], corners[5]);
    }
  }
}

CheckedVolumes checkCells(const InputGrid& input)
{
  const auto& grid = std::get<UnstructuredGrid>(input.grid);
  CheckedVolumes result;
  result.smallest = std::numeric_limits<double>::infinity();
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const double volume = cellVolume(grid, cell);
    const double size = sizeOf(grid, cell);
    const double smallest = degenerateVolume * size * size * size;
    result.sum += volume;
    result.smallest = std::min(result.smallest, volume);
    if (volume > smallest)
    {
      continue;
    }
    std::ostringstream message;
    message << "The volume of " << describeCell(input, cell) << " is " << volume
            << (volume < -smallest ? ": its corners are in inverted order" : ": it is degenerate");
    throw InvalidInput(message.str());
  }
  return result;
}

bool fillsBox(const UnstructuredGrid& grid, const CheckedVolumes& volumes)
{
  Box box;
  for (const Vector& point : grid.points)
  {
    box.add(point);
  }
  const double space = std::abs(box.volume() - volumes.sum);
  return space <= std::min(emptyPartOfBox * box.volume(), emptyPartOfCell * volumes.smallest);
}
}
