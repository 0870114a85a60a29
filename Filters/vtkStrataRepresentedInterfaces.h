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

class VTKSTRATAFILTERS_EXPORT vtkStrataRepresentedInterfaces : public vtkPolyDataAlgorithm
{
public:
  static vtkStrataRepresentedInterfaces* New();
  vtkTypeMacro(vtkStrataRepresentedInterfaces, vtkPolyDataAlgorithm);

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
