/**
 * @class vtkStrataMaterialsFilter
 * @brief base of the filters that take some materials out of a representation
 */
#ifndef vtkStrataMaterialsFilter_h
#define vtkStrataMaterialsFilter_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkStrataFiltersModule.h" // for the export macro

#include <memory> // for Lists

class VTKSTRATAFILTERS_EXPORT vtkStrataMaterialsFilter : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkStrataMaterialsFilter, vtkDataObjectAlgorithm);

  ///@{
  /** Names of the materials to take; none: all with fields. */
  void AddMaterial(const char* name);
  void ClearMaterials();
  ///@}

protected:
  vtkStrataMaterialsFilter();
  ~vtkStrataMaterialsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  struct Lists;
  std::unique_ptr<Lists> MaterialLists;

private:
  vtkStrataMaterialsFilter(const vtkStrataMaterialsFilter&) = delete;
  void operator=(const vtkStrataMaterialsFilter&) = delete;
};

#endif
