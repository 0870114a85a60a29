#pragma once

#include "Conversion/UnstructuredBuilder.h"

class vtkHyperTreeGrid;

namespace strata::conversion
{
/// Adds the visible leaves of a three-dimensional hyper tree grid as hexahedra.
void addHyperTrees(UnstructuredBuilder& builder, vtkHyperTreeGrid* data, const std::string& blockName);
}
