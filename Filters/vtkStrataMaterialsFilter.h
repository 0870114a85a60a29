/**
 * @class vtkStrataMaterialsFilter
 * @brief base of the filters that take some materials out of a representation
 */
#ifndef vtkStrataMaterialsFilter_h
#define vtkStrataMaterialsFilter_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkNew.h"                 // for a member
#include "vtkStrataFiltersModule.h" // for the export macro

#include <memory> // for Lists

class vtkStringArray;

class VTKSTRATAFILTERS_EXPORT vtkStrataMaterialsFilter : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkStrataMaterialsFilter, vtkDataObjectAlgorithm);

  ///@{
  /** Names of the materials to take; none: all with fields. */
  void AddMaterial(const char* name);
  void ClearMaterials();
  ///@}

  /** The materials that the input is likely to have, to choose from; empty while there is no input. */
  vtkStringArray* GetInputMaterials();

protected:
  vtkStrataMaterialsFilter();
  ~vtkStrataMaterialsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  struct Lists;
  std::unique_ptr<Lists> MaterialLists;

  vtkNew<vtkStringArray> InputMaterials;

private:
  vtkStrataMaterialsFilter(const vtkStrataMaterialsFilter&) = delete;
  void operator=(const vtkStrataMaterialsFilter&) = delete;
};

#endif
