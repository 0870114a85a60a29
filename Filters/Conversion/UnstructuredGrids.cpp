#include "Conversion/UnstructuredGrids.h"

#include "Conversion/CurvedCells.h"
#include "Conversion/StructuredGrids.h"
#include "Conversion/ValueConversion.h"

#include "Geometry/Box.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

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
  const Index* pointsOf(Index cell) const { return points.data() + offsets[static_cast<std::size_t>(cell)]; }
  Index pointCount(Index cell) const
  {
    return offsets[static_cast<std::size_t>(cell) + 1] - offsets[static_cast<std::size_t>(cell)];
  }

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

/// A curved cell whose nodes lie within this part of its size from the straight one between its corners is straight.
constexpr double straightTolerance = 1e-6;

Vector blendOf(const NodeWeights& weights, const std::vector<Vector>& positions, const Index* points)
{
  Vector sum = Vector::Zero();
  for (const auto& [node, weight] : weights)
  {
    sum += weight * positions[static_cast<std::size_t>(points[node])];
  }
  return sum;
}

bool isStraight(const CurvedPattern& pattern, const std::vector<Vector>& positions, const Index* points)
{
  double farthest = 0.0;
  Box box;
  for (std::size_t i = 0; i < pattern.points.size(); ++i)
  {
    const Vector place = blendOf(pattern.points[i], positions, points);
    farthest = std::max(farthest, (place - blendOf(pattern.straight[i], positions, points)).norm());
    box.add(place);
  }
  return farthest <= straightTolerance * box.diagonal();
}

/// The curved cells of a data set: cut into linear pieces if any of them is curved, or if a field at points may be.
class CurvedCells
{
public:
  CurvedCells(vtkUnstructuredGrid* data, const Connectivity& cells, const std::vector<Vector>& positions) :
    patterns_(data)
  {
    cut_ = hasFloatingValues(data->GetPointData());
    for (Index cell = 0; cell < cells.cellCount() && !cut_; ++cell)
    {
      const int type = data->GetCellTypesArray()->GetValue(cell);
      const Index* points = cells.pointsOf(cell);
      const bool known = std::all_of(points, points + cells.pointCount(cell),
        [&](Index point) { return point >= 0 && point < static_cast<Index>(positions.size()); });
      const auto pattern = cellKind(type).use == CellKind::Use::Linearized && known
                             ? patterns_.of(cell, type, cells.pointCount(cell))
                             : nullptr;
      cut_ = pattern && !isStraight(*pattern, positions, points);
    }
  }

  void add(UnstructuredBuilder& builder, Index cell, int type, const Index* points, Index pointCount)
  {
    builder.checkPoints(cell, points, pointCount);
    const auto pattern = patterns_.of(cell, type, pointCount);
    if (pattern && cut_)
    {
      builder.addCurved(pattern, cell, points);
      return;
    }
    if (!pattern)
    {
      builder.straighten();
    }
    builder.weldAtTheEnd();
    builder.add(cellKind(type), cell, points, pointCount);
  }

private:
  static bool hasFloatingValues(vtkDataSetAttributes* values)
  {
    bool result = false;
    for (int i = 0; i < values->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = values->GetArray(i);
      result = result || (array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE));
    }
    return result;
  }

  CurvedPatterns patterns_;
  bool cut_ = false;
};
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
  std::vector<Vector> positions = positionsOf(data->GetPoints());
  CurvedCells curved(data, cells, positions);
  builder.beginBlock(blockOf(data, blockName), std::move(positions));
  for (Index cell = 0; cell < cells.cellCount(); ++cell)
  {
    const int type = types->GetValue(cell);
    const CellKind& kind = cellKind(type);
    const Index* points = cells.pointsOf(cell);
    const Index pointCount = cells.pointCount(cell);
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
    else if (kind.use == CellKind::Use::Linearized)
    {
      curved.add(builder, cell, type, points, pointCount);
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
