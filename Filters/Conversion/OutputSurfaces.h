#pragma once

#include "Extract/Extract.h"
#include "Model/Interfaces.h"
#include "Model/Materials.h"

#include <vector>

class vtkFieldData;
class vtkPartitionedDataSetCollection;

namespace strata::conversion
{
/// Adds one surface per pair of materials to a collection, as blocks named `<positive>|<negative>` with point
/// normals and the cell arrays `positive_material` and `negative_material`, and an assembly that lists them by
/// pair and by material.
void writeInterfaces(const Interfaces& interfaces, const Materials& materials, vtkPartitionedDataSetCollection* output);

/// Field data with the volumes per material: `volume_given`, `volume_reconstructed`, `volume_error_largest`,
/// `volume_error_mean`.
void writeVolumes(const std::vector<VolumeReport>& volumes, vtkFieldData* data);
}
