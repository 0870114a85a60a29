#include "vtkStrataSample.h"

#include "Conversion/Guarded.h"
#include "Conversion/InputRepresentation.h"
#include "Conversion/OutputSamples.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataSample);

vtkStrataSample::vtkStrataSample()
{
  this->SetNumberOfInputPorts(2);
}

int vtkStrataSample::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkDataSet");
  return 1;
}

int vtkStrataSample::RequestDataObject(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* points = vtkDataSet::GetData(inputs[1]);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  if (points && (!output || !output->IsA(points->GetClassName())))
  {
    const auto made = vtkSmartPointer<vtkDataSet>::Take(points->NewInstance());
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return points ? 1 : 0;
}

int vtkStrataSample::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* points = vtkDataSet::GetData(inputs[1]);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  return conversion::guarded(this, output, [&](strata::Progress& progress) {
    const auto input = conversion::readRepresentation(vtkDataObject::GetData(inputs[0]));
    const std::vector<double> coordinates = conversion::coordinatesOf(points);
    progress.stage("Sampling", 0.0, 1.0);
    strata::Samples samples =
      strata::sample(input.view, coordinates.data(), static_cast<strata::Index>(coordinates.size() / 3), progress);
    output->ShallowCopy(points);
    conversion::writeSamples(std::move(samples), input.view, output);
  });
}
