#include "ImageScene.h"

#include "vtkStrataCaseReader.h"
#include "vtkStrataMaterialInterfaces.h"

#include <vtkCompositeDataGeometryFilter.h>
#include <vtkNew.h>

int TestInterfacesImage(int argc, char* argv[])
{
  vtkNew<vtkStrataCaseReader> reader;
  reader->SetFileName((dataFolder(argc, argv) + "/impact/impact.strata").c_str());
  reader->UpdateTimeStep(15.0);
  vtkNew<vtkStrataMaterialInterfaces> interfaces;
  interfaces->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkCompositeDataGeometryFilter> geometry;
  geometry->SetInputConnection(interfaces->GetOutputPort());
  ImageScene scene(geometry->GetOutputPort());
  scene.colorByCells("negative_material", 0.0, 3.0);
  return scene.compare(argc, argv);
}
