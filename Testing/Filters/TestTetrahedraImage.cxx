#include "ImageScene.h"

#include "vtkStrataCaseReader.h"
#include "vtkStrataTetrahedra.h"

#include <vtkNew.h>

int TestTetrahedraImage(int argc, char* argv[])
{
  vtkNew<vtkStrataCaseReader> reader;
  reader->SetFileName((dataFolder(argc, argv) + "/impact/impact.strata").c_str());
  reader->UpdateTimeStep(15.0);
  vtkNew<vtkStrataTetrahedra> tetrahedra;
  tetrahedra->SetInputConnection(reader->GetOutputPort());
  tetrahedra->SetInterfaceErrorBound(0.3);
  ImageScene scene(tetrahedra->GetOutputPort());
  scene.colorByPoints("density", 0.0, 18.0);
  scene.showEdges();
  return scene.compare(argc, argv);
}
