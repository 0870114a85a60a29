#include "Conversion/CheckCells.h"

#include "Conversion/CellVolumes.h"
#include "Conversion/RemoveCells.h"
#include "Conversion/RepeatedCells.h"

#include "Geometry/Box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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

std::string describeVolume(const InputGrid& input, Index cell, double volume, bool inverted)
{
  std::ostringstream message;
  message << "The volume of " << describeCell(input, cell) << " is " << volume
          << (inverted ? ": its corners are in inverted order" : ": it is degenerate");
  return message.str();
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

CheckedVolumes dropCellsWithoutVolume(InputGrid& input)
{
  const auto& grid = std::get<UnstructuredGrid>(input.grid);
  std::vector<double> volumes(grid.shapes.size());
  std::vector<Index> sources;
  std::string reason;
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const auto c = static_cast<std::size_t>(cell);
    volumes[c] = cellVolume(grid, cell);
    const double size = sizeOf(grid, cell);
    const double smallest = degenerateVolume * size * size * size;
    if (!(volumes[c] > smallest) && (sources.empty() || sources.back() != input.cellSource[c]))
    {
      reason = sources.empty() ? describeVolume(input, cell, volumes[c], volumes[c] < -smallest) : reason;
      sources.push_back(input.cellSource[c]);
    }
  }
  std::vector<Index> bad;
  CheckedVolumes result;
  result.smallest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < volumes.size(); ++c)
  {
    // All pieces of a curved cell one of which is inverted.
    if (std::binary_search(sources.begin(), sources.end(), input.cellSource[c]))
    {
      bad.push_back(static_cast<Index>(c));
      continue;
    }
    result.sum += volumes[c];
    result.smallest = std::min(result.smallest, volumes[c]);
  }
  if (bad.size() == volumes.size())
  {
    throw InvalidInput(reason + ". No cell is left");
  }
  if (!bad.empty())
  {
    input.warnings.push_back(
      reason + ". Cells left out, inverted or without volume: " + std::to_string(sources.size()));
    removeCells(input, bad);
  }
  return result;
}

void dropRepeatedCells(InputGrid& input, CheckedVolumes& volumes)
{
  const auto& grid = std::get<UnstructuredGrid>(input.grid);
  std::vector<Index> repeated;
  std::string first;
  for (const auto& [cell, earlier] : repeatedCells(grid))
  {
    volumes.sum -= cellVolume(grid, cell);
    first =
      repeated.empty() ? describeCell(input, cell) + " has the corners of " + describeCell(input, earlier) : first;
    repeated.push_back(cell);
  }
  if (!repeated.empty())
  {
    input.warnings.push_back(
      "The grid repeats cells: " + first + ". Cells left out: " + std::to_string(repeated.size()));
    removeCells(input, repeated);
  }
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
