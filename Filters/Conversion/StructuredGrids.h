#pragma once

#include "Conversion/UnstructuredBuilder.h"

class vtkDataSet;
class vtkImageData;
class vtkRectilinearGrid;
class vtkStructuredGrid;

namespace strata::conversion
{
/// One byte per cell, 1 where a cell is hidden, a ghost, covered by finer ones, or has a hidden point; empty if
/// none is.
std::vector<std::uint8_t> hiddenCells(vtkDataSet* data);

/// A block without cells yet.
InputBlock blockOf(vtkDataSet* data, const std::string& name);

/// True for an image whose axes are those of space.
bool isAxisAligned(vtkImageData* image);

/// The grid of an axis-aligned image or a rectilinear grid. Throws InvalidInput unless the coordinates ascend.
InputGrid readRectilinear(vtkDataSet* data);

/// Adds the cells of an image, rectilinear or curvilinear grid as hexahedra, hidden ones left out.
void addStructured(UnstructuredBuilder& builder, vtkDataSet* data, const std::string& blockName);
}
