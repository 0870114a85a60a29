#include "vtkStrataExtractMaterials.h"

#include "MaterialsFilterLists.h"

#include "Conversion/Guarded.h"
#include "Conversion/InputRepresentation.h"
#include "Conversion/OutputPieces.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataExtractMaterials);

int vtkStrataExtractMaterials::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

int vtkStrataExtractMaterials::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* output = vtkUnstructuredGrid::GetData(outputs);
  return conversion::guarded(this, output, [&](strata::Progress& progress) {
    const auto input = conversion::readRepresentation(vtkDataObject::GetData(inputs[0]));
    const strata::MaterialSet materials =
      conversion::chosenMaterials(this->MaterialLists->materials, input.view.materials);
    progress.stage("Cutting the materials", 0.0, 1.0);
    conversion::writePieces(strata::cutPieces(input.view, materials, progress), input.view, output);
  });
}
