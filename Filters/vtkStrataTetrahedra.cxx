#include "vtkStrataTetrahedra.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkStrataTetrahedra);
