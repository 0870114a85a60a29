#pragma once

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkCamera.h>
#include <vtkDataSetMapper.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkProperty.h>
#include <vtkRegressionTestImage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTestUtilities.h>
#include <vtkWindowToImageFilter.h>

#include <string>

/// The folder given by -D.
inline std::string dataFolder(int argc, char* argv[])
{
  char* folder = vtkTestUtilities::ExpandDataFileName(argc, argv, "");
  const std::string result = folder;
  delete[] folder;
  return result;
}

/// A picture that is the same everywhere: fixed size, camera and background, no smoothing, no text.
class ImageScene
{
public:
  explicit ImageScene(vtkAlgorithmOutput* output)
  {
    mapper_->SetInputConnection(output);
    mapper_->ScalarVisibilityOff();
    actor_->SetMapper(mapper_);
    actor_->GetProperty()->SetInterpolationToFlat();
    renderer_->AddActor(actor_);
    renderer_->SetBackground(0.2, 0.2, 0.3);
    window_->SetMultiSamples(0);
    window_->SetSize(400, 400);
    window_->AddRenderer(renderer_);
  }

  void colorByPoints(const char* array, double low, double high)
  {
    mapper_->SetScalarModeToUsePointFieldData();
    color(array, low, high);
  }
  void colorByCells(const char* array, double low, double high)
  {
    mapper_->SetScalarModeToUseCellFieldData();
    color(array, low, high);
  }
  void showEdges() { actor_->GetProperty()->EdgeVisibilityOn(); }

  /// The result of a VTK test: 0 if the picture agrees with the baseline. Leaves the picture, called after the test, in
  /// the folder given by -T, for the sharper comparison that follows.
  int compare(int argc, char* argv[])
  {
    renderer_->GetActiveCamera()->SetPosition(-30.0, -50.0, 25.0);
    renderer_->GetActiveCamera()->SetFocalPoint(6.0, 6.0, -5.6);
    renderer_->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    renderer_->ResetCamera();
    window_->Render();
    write(argc, argv);
    return vtkRegressionTestImageThreshold(window_, 15.0) == vtkRegressionTester::PASSED ? 0 : 1;
  }

private:
  void write(int argc, char* argv[])
  {
    char* folder = vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
    vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(window_);
    picture->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(picture->GetOutputPort());
    writer->SetFileName((std::string(folder) + "/" + argv[0] + ".picture.png").c_str());
    writer->Write();
    delete[] folder;
  }

  void color(const char* array, double low, double high)
  {
    mapper_->ScalarVisibilityOn();
    mapper_->SelectColorArray(array);
    mapper_->SetScalarRange(low, high);
  }

  vtkNew<vtkDataSetMapper> mapper_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
};
