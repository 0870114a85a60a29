/**
 * @class vtkStrataSample
 * @brief evaluates a representation at the points of any data set
 *
 * Port 0 takes the representation, port 1 the points. The output is the data set of port 1 with the point arrays
 * `material`, each `<field>` and `outside`.
 */
#ifndef vtkStrataSample_h
#define vtkStrataSample_h

#include "vtkDataSetAlgorithm.h"
#include "vtkStrataFiltersModule.h" // for the export macro

class VTKSTRATAFILTERS_EXPORT vtkStrataSample : public vtkDataSetAlgorithm
{
public:
  static vtkStrataSample* New();
  vtkTypeMacro(vtkStrataSample, vtkDataSetAlgorithm);

protected:
  vtkStrataSample();
  ~vtkStrataSample() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkStrataSample(const vtkStrataSample&) = delete;
  void operator=(const vtkStrataSample&) = delete;
};

#endif
