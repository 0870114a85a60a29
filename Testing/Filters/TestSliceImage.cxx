#include "ImageScene.h"

#include "vtkStrataCaseReader.h"
#include "vtkStrataSlice.h"
#include "vtkStrataTetrahedra.h"

#include <vtkNew.h>
#include <vtkPlane.h>

int TestSliceImage(int argc, char* argv[])
{
  vtkNew<vtkStrataCaseReader> reader;
  reader->SetFileName((dataFolder(argc, argv) + "/impact/impact.strata").c_str());
  reader->UpdateTimeStep(15.0);
  vtkNew<vtkStrataTetrahedra> tetrahedra;
  tetrahedra->SetInputConnection(reader->GetOutputPort());
  tetrahedra->SetInterfaceErrorBound(0.15);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(6.0, 0.001, 0.0);
  plane->SetNormal(0.0, -1.0, 0.0);
  vtkNew<vtkStrataSlice> slice;
  slice->SetInputConnection(tetrahedra->GetOutputPort());
  slice->SetSliceType(plane);
  ImageScene scene(slice->GetOutputPort());
  scene.colorByPoints("density", 7.0, 18.0);
  return scene.compare(argc, argv);
}
