#include "Conversion/OutputPolygons.h"

#include "Conversion/CaseData.h"
#include "Conversion/ValueConversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>

namespace strata::conversion
{
void writePolygons(MaterialPolygons&& polygons, const Representation& representation, vtkPolyData* output)
{
  writeMaterials(representation.materials, output->GetFieldData());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(give<vtkDoubleArray>("Points", std::move(polygons.points), 3));
  output->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  if (polygons.offsets.size() > 1)
  {
    cells->SetData(give<vtkTypeInt64Array>("", std::move(polygons.offsets)).Get(),
      give<vtkTypeInt64Array>("", std::move(polygons.corners)).Get());
  }
  output->SetPolys(cells);
  output->GetCellData()->AddArray(give<vtkIntArray>("material", std::move(polygons.material)));
  output->GetCellData()->AddArray(give<vtkTypeInt64Array>("tetrahedron", std::move(polygons.tetrahedron)));
  for (std::size_t f = 0; f < polygons.values.size(); ++f)
  {
    const Field& field = representation.fields[f];
    output->GetPointData()->AddArray(give<vtkFloatArray>(field.name, std::move(polygons.values[f]), field.components));
  }
  if (!representation.fields.empty())
  {
    output->GetPointData()->SetActiveScalars(representation.fields.front().name.c_str());
  }
}
}
