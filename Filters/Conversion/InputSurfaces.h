#pragma once

#include "Conversion/CaseData.h"

#include "Model/Errors.h"
#include "Model/Interfaces.h"

namespace strata::conversion
{
/// Makes one triangle mesh of surfaces: quads and strips are cut into triangles, coincident points welded,
/// triangles without area dropped. Which materials a surface parts is said by its cell arrays
/// `positive_material` and `negative_material`, or by its name `<positive>|<negative>`. Normals, where there are
/// any, point into the positive material, and triangles turn to agree with them.
/// Throws InvalidInput for lines, for points out of range and for unknown materials.
Interfaces readInterfaces(const std::vector<NamedSurface>& surfaces, const Materials& materials, Warnings& warnings);
}
