#include "Conversion/UnstructuredGrids.h"

#include "Conversion/StructuredGrids.h"
#include "Conversion/ValueConversion.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkIdTypeArray.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

namespace strata::conversion
{
namespace
{
/// The cells of a vtkCellArray in plain memory.
struct Connectivity
{
  explicit Connectivity(vtkCellArray* cells)
  {
    if (cells && cells->GetNumberOfCells() > 0)
    {
      offsets = integersOf(cells->GetOffsetsArray());
      points = integersOf(cells->GetConnectivityArray());
    }
  }
  Index cellCount() const { return offsets.empty() ? 0 : static_cast<Index>(offsets.size()) - 1; }

  /// Throws InvalidInput where a cell's range of points lies outside the list.
  void check(const std::string& blockName) const
  {
    for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell)
    {
      if (offsets[cell] < 0 || offsets[cell + 1] < offsets[cell] ||
          offsets[cell + 1] > static_cast<Index>(points.size()))
      {
        throw InvalidInput("Cell " + std::to_string(cell) + blockName + " has a list of points that is out of range");
      }
    }
  }

  std::vector<std::int64_t> offsets;
  std::vector<std::int64_t> points;
};

void addPolyhedron(UnstructuredBuilder& builder, vtkUnstructuredGrid* data, Index cell, const Index* points,
  Index pointCount, const std::string& blockName)
{
  vtkIdTypeArray* faces = data->GetFaces();
  vtkIdTypeArray* locations = data->GetFaceLocations();
  const Index size = faces ? faces->GetNumberOfValues() : 0;
  Index at = locations && cell < locations->GetNumberOfValues() ? locations->GetValue(cell) : -1;
  const Index faceCount = at >= 0 && at < size ? faces->GetValue(at) : -1;
  const Index begin = ++at;
  bool complete = faceCount >= 4;
  for (Index f = 0; complete && f < faceCount; ++f)
  {
    complete = at < size && faces->GetValue(at) >= 3 && faces->GetValue(at) < size - at;
    at += complete ? faces->GetValue(at) + 1 : 0;
  }
  if (!complete)
  {
    throw InvalidInput("Polyhedron " + std::to_string(cell) + blockName + " has no usable list of faces");
  }
  const std::vector<Index> list(faces->GetPointer(begin), faces->GetPointer(begin) + (at - begin));
  builder.addPolyhedron(cell, points, pointCount, list.data(), faceCount);
}
}

void addUnstructured(UnstructuredBuilder& builder, vtkUnstructuredGrid* data, const std::string& blockName)
{
  const Connectivity cells(data->GetCells());
  cells.check(blockName);
  vtkUnsignedCharArray* types = data->GetCellTypesArray();
  if (cells.cellCount() > 0 && (!types || types->GetNumberOfValues() < cells.cellCount()))
  {
    throw InvalidInput("The grid" + blockName + " lists fewer cell types than cells");
  }
  const std::vector<std::uint8_t> hidden = hiddenCells(data);
  builder.beginBlock(blockOf(data, blockName), positionsOf(data->GetPoints()));
  for (Index cell = 0; cell < cells.cellCount(); ++cell)
  {
    const int type = types->GetValue(cell);
    const CellKind& kind = cellKind(type);
    const Index* points = cells.points.data() + cells.offsets[static_cast<std::size_t>(cell)];
    const Index pointCount =
      cells.offsets[static_cast<std::size_t>(cell) + 1] - cells.offsets[static_cast<std::size_t>(cell)];
    if (kind.use == CellKind::Use::Unknown)
    {
      throw InvalidInput("Cell " + std::to_string(cell) + blockName + " has the type " + std::to_string(type) +
                         ", which is not supported");
    }
    if (!hidden.empty() && hidden[static_cast<std::size_t>(cell)])
    {
      continue;
    }
    if (kind.use == CellKind::Use::Ignored)
    {
      builder.ignore();
    }
    else if (kind.use == CellKind::Use::Polyhedron)
    {
      addPolyhedron(builder, data, cell, points, pointCount, blockName);
    }
    else
    {
      builder.add(kind, cell, points, pointCount);
    }
  }
}

void addExplicit(UnstructuredBuilder& builder, vtkExplicitStructuredGrid* data, const std::string& blockName)
{
  const Connectivity cells(data->GetCells());
  cells.check(blockName);
  const std::vector<std::uint8_t> hidden = hiddenCells(data);
  const CellKind& kind = cellKind(VTK_HEXAHEDRON);
  builder.beginBlock(blockOf(data, blockName), positionsOf(data->GetPoints()));
  builder.weldAtTheEnd();
  for (Index cell = 0; cell < cells.cellCount(); ++cell)
  {
    if (hidden.empty() || !hidden[static_cast<std::size_t>(cell)])
    {
      const Index begin = cells.offsets[static_cast<std::size_t>(cell)];
      builder.add(kind, cell, cells.points.data() + begin, cells.offsets[static_cast<std::size_t>(cell) + 1] - begin);
    }
  }
}
}
