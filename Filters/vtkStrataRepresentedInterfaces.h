/**
 * @class vtkStrataRepresentedInterfaces
 * @brief the interfaces of a representation as triangles
 *
 * Each triangle knows the materials and the fields of both sides, and their jump.
 */
#ifndef vtkStrataRepresentedInterfaces_h
#define vtkStrataRepresentedInterfaces_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkStrataFiltersModule.h" // for the export macro

#include <string>

class VTKSTRATAFILTERS_EXPORT vtkStrataRepresentedInterfaces : public vtkPolyDataAlgorithm
{
public:
  static vtkStrataRepresentedInterfaces* New();
  vtkTypeMacro(vtkStrataRepresentedInterfaces, vtkPolyDataAlgorithm);

  /** What the numbers of the output's cell array `pair` stand for, a line "<number><tab><name>" each. */
  std::string GetLegend();

protected:
  vtkStrataRepresentedInterfaces() = default;
  ~vtkStrataRepresentedInterfaces() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkStrataRepresentedInterfaces(const vtkStrataRepresentedInterfaces&) = delete;
  void operator=(const vtkStrataRepresentedInterfaces&) = delete;
};

#endif
