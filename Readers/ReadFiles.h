#pragma once

#include <vtkDataObject.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// Reads a grid with VTK's own readers (.vti .vtr .vts .vtu .vtm .vtmb .vth .vthb .htg .vtpc, parallel ones, .vtk).
/// Throws strata::InvalidInput that names the file if it is missing, unknown or empty.
vtkSmartPointer<vtkDataObject> readGridFile(const std::string& path);

/// Reads a surface (.vtp .vtk .stl .ply .obj).
vtkSmartPointer<vtkPolyData> readSurfaceFile(const std::string& path);
