#include "Conversion/OutputPieces.h"

#include "Conversion/CaseData.h"
#include "Conversion/Legend.h"
#include "Conversion/ValueConversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>

#include <numeric>

namespace strata::conversion
{
namespace
{
vtkSmartPointer<vtkPoints> pointsOf(Buffer<double>&& coordinates)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetData(give<vtkDoubleArray>("Points", std::move(coordinates), 3));
  return points;
}

/// The corners of triangles, three points for each.
Buffer<double> cornerPoints(const RepresentedSurfaces& surfaces)
{
  Buffer<double> result(3 * surfaces.triangles.size());
  for (Index i = 0; i < surfaces.triangles.size(); ++i)
  {
    std::copy_n(surfaces.points.data() + 3 * surfaces.triangles[i], 3, result.data() + 3 * i);
  }
  return result;
}

Buffer<float> jump(const Buffer<float>& positive, const Buffer<float>& negative)
{
  Buffer<float> result(positive.size());
  for (Index i = 0; i < result.size(); ++i)
  {
    result[i] = positive[i] - negative[i];
  }
  return result;
}
}

void writePieces(Pieces&& pieces, const Representation& representation, vtkUnstructuredGrid* output)
{
  writeMaterials(representation.materials, output->GetFieldData());
  output->SetPoints(pointsOf(std::move(pieces.points)));
  vtkNew<vtkCellArray> cells;
  cells->SetData(4, give<vtkTypeInt64Array>("", std::move(pieces.tetrahedra)));
  output->SetCells(VTK_TETRA, cells);
  output->GetCellData()->AddArray(give<vtkIntArray>("material", std::move(pieces.material)));
  output->GetCellData()->AddArray(give<vtkTypeInt64Array>("cell", std::move(pieces.cell)));
  vtkPointData* data = output->GetPointData();
  for (std::size_t f = 0; f < pieces.values.size(); ++f)
  {
    const Field& field = representation.fields[f];
    data->AddArray(give<vtkFloatArray>(field.name, std::move(pieces.values[f]), field.components));
  }
  for (std::size_t m = 0; m < pieces.distances.size(); ++m)
  {
    if (pieces.distances[m].size() > 0)
    {
      data->AddArray(
        give<vtkFloatArray>("distance_" + representation.materials[m].name, std::move(pieces.distances[m])));
    }
  }
  if (!representation.fields.empty())
  {
    data->SetActiveScalars(representation.fields.front().name.c_str());
  }
}

void writeRepresentedSurfaces(RepresentedSurfaces&& surfaces, const Representation& representation, vtkPolyData* output)
{
  writeMaterials(representation.materials, output->GetFieldData());
  output->SetPoints(pointsOf(cornerPoints(surfaces)));
  Buffer<std::int64_t> corners(surfaces.triangles.size());
  std::iota(corners.begin(), corners.end(), std::int64_t{ 0 });
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, give<vtkTypeInt64Array>("", std::move(corners)));
  output->SetPolys(cells);
  Buffer<std::int32_t> pairs(surfaces.positive.size());
  for (Index i = 0; i < pairs.size(); ++i)
  {
    pairs[i] =
      pairNumber(surfaces.positive[i], surfaces.negative[i], static_cast<int>(representation.materials.size()));
  }
  output->GetCellData()->AddArray(give<vtkIntArray>(names::pair, std::move(pairs)));
  output->GetCellData()->AddArray(give<vtkIntArray>(names::positive, std::move(surfaces.positive)));
  output->GetCellData()->AddArray(give<vtkIntArray>(names::negative, std::move(surfaces.negative)));
  output->GetCellData()->AddArray(give<vtkTypeInt64Array>("cell", std::move(surfaces.cell)));
  for (std::size_t f = 0; f < surfaces.positiveValues.size(); ++f)
  {
    const Field& field = representation.fields[f];
    Buffer<float>& positive = surfaces.positiveValues[f];
    Buffer<float>& negative = surfaces.negativeValues[f];
    vtkPointData* data = output->GetPointData();
    data->AddArray(give<vtkFloatArray>(field.name + "_jump", jump(positive, negative), field.components));
    data->AddArray(give<vtkFloatArray>(field.name + "_positive", std::move(positive), field.components));
    data->AddArray(give<vtkFloatArray>(field.name + "_negative", std::move(negative), field.components));
  }
}
}
