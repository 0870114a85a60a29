/**
 * @class vtkSMStrataCategories
 * @brief gives a filter's views a categorical colour map with names
 *
 * An initialization helper: when a view of the filter's output is first made, in the window, pvpython or pvbatch, it is
 * coloured by the cell array that the hint's attribute `array` names. The categories and their names are those of the
 * filter's property `Legend`; a category's colour depends on its number alone, so that it stays the same over time.
 * Where another data set has given the array's colour map other names, the view gets a map of its own. Views that a
 * state file brings along are left as they are.
 */
#ifndef vtkSMStrataCategories_h
#define vtkSMStrataCategories_h

#include "vtkSMProxyInitializationHelper.h"
#include "vtkStrataViewsModule.h"

class VTKSTRATAVIEWS_EXPORT vtkSMStrataCategories : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMStrataCategories* New();
  vtkTypeMacro(vtkSMStrataCategories, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTime) override;

protected:
  vtkSMStrataCategories() = default;
  ~vtkSMStrataCategories() override = default;

private:
  vtkSMStrataCategories(const vtkSMStrataCategories&) = delete;
  void operator=(const vtkSMStrataCategories&) = delete;
};

#endif
