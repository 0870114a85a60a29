#pragma once

#include "Conversion/UnstructuredBuilder.h"

class vtkExplicitStructuredGrid;
class vtkUnstructuredGrid;

namespace strata::conversion
{
/// Adds the visible cells of a grid. Throws InvalidInput that names a cell of unknown type.
void addUnstructured(UnstructuredBuilder& builder, vtkUnstructuredGrid* data, const std::string& blockName);
void addExplicit(UnstructuredBuilder& builder, vtkExplicitStructuredGrid* data, const std::string& blockName);
}
