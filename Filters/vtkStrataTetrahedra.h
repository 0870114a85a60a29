#ifndef vtkStrataTetrahedra_h
#define vtkStrataTetrahedra_h

#include "vtkStrataFiltersModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

/// Refines a simulation into tetrahedra whose errors stay within bounds.
class VTKSTRATAFILTERS_EXPORT vtkStrataTetrahedra : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkStrataTetrahedra* New();
  vtkTypeMacro(vtkStrataTetrahedra, vtkUnstructuredGridAlgorithm);

protected:
  vtkStrataTetrahedra() = default;
  ~vtkStrataTetrahedra() override = default;

private:
  vtkStrataTetrahedra(const vtkStrataTetrahedra&) = delete;
  void operator=(const vtkStrataTetrahedra&) = delete;
};

#endif
