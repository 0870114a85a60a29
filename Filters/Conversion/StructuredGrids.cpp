#include "Conversion/StructuredGrids.h"

#include "Conversion/ValueConversion.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace strata::conversion
{
namespace
{
using Dimensions = std::array<Index, 3>;
using Axes = std::array<std::vector<double>, 3>;

constexpr unsigned char hiddenCell =
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL;

const unsigned char* ghosts(vtkDataSetAttributes* data, Index count)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return array && array->GetNumberOfTuples() == count && count > 0 ? array->GetPointer(0) : nullptr;
}

Dimensions pointDimensions(vtkDataSet* data)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetExtent(extent);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetExtent(extent);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetExtent(extent);
  }
  return { Index{ extent[1] } - extent[0] + 1, Index{ extent[3] } - extent[2] + 1, Index{ extent[5] } - extent[4] + 1 };
}

Axes axesOf(vtkImageData* image)
{
  const int* extent = image->GetExtent();
  Axes axes;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double spacing = image->GetSpacing()[axis];
    for (int i = extent[2 * axis]; i <= extent[2 * axis + 1]; ++i)
    {
      axes[axis].push_back(image->GetOrigin()[axis] + i * spacing);
    }
  }
  return axes;
}

Axes axesOf(vtkRectilinearGrid* grid)
{
  vtkDataArray* const coordinates[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() };
  const Dimensions size = pointDimensions(grid);
  Axes axes;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Index count = coordinates[axis] ? coordinates[axis]->GetNumberOfTuples() : 0;
    if (count != size[axis])
    {
      throw InvalidInput("The grid has " + std::to_string(count) + " coordinates along " + "xyz"[axis] +
                         "; its extent needs " + std::to_string(size[axis]));
    }
    const ValueArray values = count > 0 ? valuesOf(coordinates[axis]) : ValueArray();
    for (Index i = 0; i < count; ++i)
    {
      axes[axis].push_back(values(i));
    }
  }
  return axes;
}

void checkAscending(const Axes& axes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < axes[axis].size(); ++i)
    {
      const double value = axes[axis][i];
      // Below the normal numbers, cells have volumes that round to nothing.
      if (!std::isfinite(value) || (i > 0 && !(value - axes[axis][i - 1] >= std::numeric_limits<double>::min())))
      {
        std::ostringstream message;
        message << "The coordinates along "
                << "xyz"[axis] << " must be finite and ascend (spacing above zero); number " << i << " is " << value;
        if (i > 0)
        {
          message << " after " << axes[axis][i - 1];
        }
        throw InvalidInput(message.str());
      }
    }
  }
}

std::vector<Vector> pointsOf(const Axes& axes)
{
  std::vector<Vector> points;
  points.reserve(axes[0].size() * axes[1].size() * axes[2].size());
  for (const double z : axes[2])
    for (const double y : axes[1])
      for (const double x : axes[0])
      {
        points.emplace_back(x, y, z);
      }
  return points;
}

/// Points of an image whose axes are turned.
std::vector<Vector> turnedPoints(vtkImageData* image)
{
  std::vector<Vector> points = pointsOf(axesOf(image));
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> turn(image->GetDirectionMatrix()->GetData());
  const Vector origin(image->GetOrigin());
  for (Vector& point : points)
  {
    point = origin + turn * (point - origin);
  }
  return points;
}

std::vector<Vector> structuredPoints(vtkDataSet* data)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    return turnedPoints(image);
  }
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    return pointsOf(axesOf(rectilinear));
  }
  return positionsOf(vtkStructuredGrid::SafeDownCast(data)->GetPoints());
}

std::array<Index, 8> hexahedron(const Dimensions& n, Index i, Index j, Index k)
{
  const Index below = i + n[0] * (j + n[1] * k);
  const Index above = below + n[0] * n[1];
  return { below, below + 1, below + 1 + n[0], below + n[0], above, above + 1, above + 1 + n[0], above + n[0] };
}

/// True where the axes i, j, k form a left-handed frame, summed over the grid: the hexahedra then turn over.
bool isLeftHanded(const std::vector<Vector>& points, const Dimensions& n)
{
  double sum = 0.0;
  for (Index k = 0; k + 1 < n[2]; ++k)
    for (Index j = 0; j + 1 < n[1]; ++j)
      for (Index i = 0; i + 1 < n[0]; ++i)
      {
        const auto c = hexahedron(n, i, j, k);
        const Vector& p = points[static_cast<std::size_t>(c[0])];
        const double volume = (points[static_cast<std::size_t>(c[1])] - p)
                                .cross(points[static_cast<std::size_t>(c[3])] - p)
                                .dot(points[static_cast<std::size_t>(c[4])] - p);
        sum += std::isfinite(volume) ? volume : 0.0;
      }
  return sum < 0.0;
}
}

std::vector<std::uint8_t> hiddenCells(vtkDataSet* data)
{
  std::vector<std::uint8_t> hidden;
  const Index cells = data->GetNumberOfCells();
  bool any = false;
  if (const unsigned char* ghost = ghosts(data->GetCellData(), cells))
  {
    hidden.resize(static_cast<std::size_t>(cells));
    for (Index cell = 0; cell < cells; ++cell)
    {
      hidden[static_cast<std::size_t>(cell)] = (ghost[cell] & hiddenCell) != 0;
      any = any || hidden[static_cast<std::size_t>(cell)];
    }
  }
  const unsigned char* ghost = ghosts(data->GetPointData(), data->GetNumberOfPoints());
  const Dimensions n = pointDimensions(data);
  if (ghost && n[0] > 1 && n[1] > 1 && n[2] > 1)
  {
    hidden.resize(static_cast<std::size_t>(cells));
    Index cell = 0;
    for (Index k = 0; k + 1 < n[2]; ++k)
      for (Index j = 0; j + 1 < n[1]; ++j)
        for (Index i = 0; i + 1 < n[0]; ++i, ++cell)
        {
          for (const Index corner : hexahedron(n, i, j, k))
          {
            const bool hides = (ghost[corner] & vtkDataSetAttributes::HIDDENPOINT) != 0;
            hidden[static_cast<std::size_t>(cell)] |= static_cast<std::uint8_t>(hides);
            any = any || hides;
          }
        }
  }
  return any ? hidden : std::vector<std::uint8_t>{};
}

InputBlock blockOf(vtkDataSet* data, const std::string& name)
{
  InputBlock block;
  block.name = name;
  block.data = data;
  block.cellData = data->GetCellData();
  block.pointData = data->GetPointData();
  block.cellCount = data->GetNumberOfCells();
  block.pointCount = data->GetNumberOfPoints();
  return block;
}

bool isAxisAligned(vtkImageData* image)
{
  return image->GetDirectionMatrix()->IsIdentity();
}

InputGrid readRectilinear(vtkDataSet* data)
{
  RectilinearGrid grid;
  auto* image = vtkImageData::SafeDownCast(data);
  grid.coordinates = image ? axesOf(image) : axesOf(vtkRectilinearGrid::SafeDownCast(data));
  checkAscending(grid.coordinates);
  if (grid.pointCount(0) < 2 || grid.pointCount(1) < 2 || grid.pointCount(2) < 2)
  {
    std::ostringstream message;
    message << "The grid has " << grid.pointCount(0) << " x " << grid.pointCount(1) << " x " << grid.pointCount(2)
            << " points: no cells with a volume";
    throw InvalidInput(message.str());
  }
  grid.hidden = hiddenCells(data);
  if (!grid.hidden.empty() && std::find(grid.hidden.begin(), grid.hidden.end(), 0) == grid.hidden.end())
  {
    throw InvalidInput("All cells of the grid are hidden");
  }
  InputGrid result;
  result.hasOutside = !grid.hidden.empty();
  result.grid = std::move(grid);
  result.blocks.push_back(blockOf(data, ""));
  return result;
}

void addStructured(UnstructuredBuilder& builder, vtkDataSet* data, const std::string& blockName)
{
  const Dimensions n = pointDimensions(data);
  std::vector<Vector> points = structuredPoints(data);
  if (static_cast<Index>(points.size()) != n[0] * n[1] * n[2])
  {
    throw InvalidInput("The grid" + blockName + " has " + std::to_string(points.size()) + " points; its extent needs " +
                       std::to_string(n[0] * n[1] * n[2]));
  }
  const bool turnOver = isLeftHanded(points, n);
  const std::vector<std::uint8_t> hidden = hiddenCells(data);
  CellKind kind = cellKind(VTK_HEXAHEDRON);
  if (turnOver)
  {
    kind.corners = { 4, 5, 6, 7, 0, 1, 2, 3 };
  }
  builder.beginBlock(blockOf(data, blockName), std::move(points));
  Index cell = 0;
  for (Index k = 0; k + 1 < n[2]; ++k)
    for (Index j = 0; j + 1 < n[1]; ++j)
      for (Index i = 0; i + 1 < n[0]; ++i, ++cell)
      {
        if (hidden.empty() || !hidden[static_cast<std::size_t>(cell)])
        {
          const std::array<Index, 8> corners = hexahedron(n, i, j, k);
          builder.add(kind, cell, corners.data(), 8);
        }
      }
}
}
