#include "Conversion/OutputSamples.h"

#include "Conversion/CaseData.h"
#include "Conversion/ValueConversion.h"

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

namespace strata::conversion
{
std::vector<double> coordinatesOf(vtkDataSet* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  std::vector<double> result(3 * static_cast<std::size_t>(count));
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  if (pointSet && pointSet->GetPoints())
  {
    const ValueArray values = valuesOf(pointSet->GetPoints()->GetData());
    for (Index i = 0; i < count; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        result[static_cast<std::size_t>(3 * i + c)] = values(i, c);
      }
    }
    return result;
  }
  // Images and rectilinear grids have no list of points; one call for each is still cheap beside sampling.
  for (vtkIdType i = 0; i < count; ++i)
  {
    data->GetPoint(i, result.data() + 3 * i);
  }
  return result;
}

void writeSamples(Samples&& samples, const Representation& representation, vtkDataSet* output)
{
  writeMaterials(representation.materials, output->GetFieldData());
  vtkPointData* data = output->GetPointData();
  data->AddArray(give<vtkIntArray>("material", std::move(samples.material)));
  data->AddArray(give<vtkUnsignedCharArray>("outside", std::move(samples.outside)));
  for (std::size_t f = 0; f < samples.values.size(); ++f)
  {
    const Field& field = representation.fields[f];
    data->AddArray(give<vtkFloatArray>(field.name, std::move(samples.values[f]), field.components));
  }
  if (!representation.fields.empty())
  {
    data->SetActiveScalars(representation.fields.front().name.c_str());
  }
}
}
