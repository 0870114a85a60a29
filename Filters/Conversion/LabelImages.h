#pragma once

#include "Conversion/ReadSimulation.h"

#include <vtkSmartPointer.h>

class vtkDataObject;

namespace strata::conversion
{
/// An image whose points carry labels, as segmented images do, as one with a cell round each point, half a spacing
/// wider on each side: `MaterialIdArray`, or an array recognized by its name, is then an integer array at points, and
/// nothing in cells says where the materials are. Any other input comes back as it is.
vtkSmartPointer<vtkDataObject> withLabelsInCells(vtkDataObject* data, const SimulationOptions& options);
}
