#include "Conversion/CheckCells.h"

#include "Conversion/CellVolumes.h"

#include "Geometry/Box.h"

#include <sstream>
#include <utility>

namespace strata::conversion
{
namespace
{
/// Volumes below this part of the cell's box diagonal cubed are rounding errors.
constexpr double degenerateVolume = 1e-14;

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

void checkCells(const InputGrid& input)
{
  const auto& grid = std::get<UnstructuredGrid>(input.grid);
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const double volume = cellVolume(grid, cell);
    const double size = sizeOf(grid, cell);
    const double smallest = degenerateVolume * size * size * size;
    if (volume > smallest)
    {
      continue;
    }
    std::ostringstream message;
    message << "The volume of " << describeCell(input, cell) << " is " << volume
            << (volume < -smallest ? ": its corners are in inverted order" : ": it is degenerate");
    throw InvalidInput(message.str());
  }
}
}
