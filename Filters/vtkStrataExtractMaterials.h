/**
 * @class vtkStrataExtractMaterials
 * @brief cuts the solid pieces of materials out of a representation
 *
 * The tetrahedra fill exactly the region of their material: without gap or overlap, and with its fields.
 */
#ifndef vtkStrataExtractMaterials_h
#define vtkStrataExtractMaterials_h

#include "vtkStrataFiltersModule.h" // for the export macro
#include "vtkStrataMaterialsFilter.h"

class VTKSTRATAFILTERS_EXPORT vtkStrataExtractMaterials : public vtkStrataMaterialsFilter
{
public:
  static vtkStrataExtractMaterials* New();
  vtkTypeMacro(vtkStrataExtractMaterials, vtkStrataMaterialsFilter);

protected:
  vtkStrataExtractMaterials() = default;
  ~vtkStrataExtractMaterials() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkStrataExtractMaterials(const vtkStrataExtractMaterials&) = delete;
  void operator=(const vtkStrataExtractMaterials&) = delete;
};

#endif
