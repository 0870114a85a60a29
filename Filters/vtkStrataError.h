/**
 * @class vtkStrataError
 * @brief measures a representation against the simulation that it stands for
 *
 * Port 0 takes the representation, port 1 the simulation (a grid or a case), port 2 optional interface surfaces. The
 * output is a table with a row for each material and field, for each interface and for each material's volume. The
 * computation shares nothing but geometry with the one that built the representation.
 */
#ifndef vtkStrataError_h
#define vtkStrataError_h

#include "vtkStrataFiltersModule.h" // for the export macro
#include "vtkStrataSimulationFilter.h"

class VTKSTRATAFILTERS_EXPORT vtkStrataError : public vtkStrataSimulationFilter
{
public:
  static vtkStrataError* New();
  vtkTypeMacro(vtkStrataError, vtkStrataSimulationFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Width to which the intervals round Hausdorff distances close, in units of the box's diagonal. */
  vtkSetMacro(HausdorffTolerance, double);
  vtkGetMacro(HausdorffTolerance, double);
  ///@}

protected:
  vtkStrataError();
  ~vtkStrataError() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double HausdorffTolerance = 1e-3;

private:
  vtkStrataError(const vtkStrataError&) = delete;
  void operator=(const vtkStrataError&) = delete;
};

#endif
