#include "vtkStrataCaseReader.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkStrataCaseReader);
