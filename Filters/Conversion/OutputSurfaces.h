#pragma once

#include "Extract/Extract.h"
#include "Model/Interfaces.h"
#include "Model/Materials.h"

#include <vector>

class vtkFieldData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace strata::conversion
{
/// Adds one surface per pair of materials to a collection, as blocks named `<positive>|<negative>` with point
/// normals and the cell arrays `positive_material` and `negative_material`.
void writeInterfaces(const Interfaces& interfaces, const Materials& materials, vtkPartitionedDataSetCollection* output);

/// Gives a collection of surfaces, and perhaps a grid, an assembly that lists the surfaces by pair and by material.
void writeAssembly(const Materials& materials, vtkPartitionedDataSetCollection* output);

/// Says in a surface's cell arrays which materials it parts, and in its field data what they are called.
void labelSurface(vtkPolyData* surface, MaterialId positive, MaterialId negative, const Materials& materials);

/// Field data with the volumes per material: `volume_given`, `volume_reconstructed`, `volume_error_largest`,
/// `volume_error_mean`; `gathered_smearing`, to what degree smeared fractions were gathered at the interface.
void writeVolumes(const ExtractedInterfaces& found, vtkFieldData* data);
}
