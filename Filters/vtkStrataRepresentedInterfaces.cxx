#include "vtkStrataRepresentedInterfaces.h"

#include "Conversion/Guarded.h"
#include "Conversion/InputRepresentation.h"
#include "Conversion/Legend.h"
#include "Conversion/OutputPieces.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataRepresentedInterfaces);

int vtkStrataRepresentedInterfaces::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkStrataRepresentedInterfaces::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* output = vtkPolyData::GetData(outputs);
  return conversion::guarded(this, output, [&](strata::Progress& progress) {
    const auto input = conversion::readRepresentation(vtkDataObject::GetData(inputs[0]));
    progress.stage("Cutting the interfaces", 0.0, 1.0);
    conversion::writeRepresentedSurfaces(strata::representedInterfaces(input.view, progress), input.view, output);
  });
}

std::string vtkStrataRepresentedInterfaces::GetLegend()
{
  return conversion::legendOf(this->GetOutputDataObject(0));
}
