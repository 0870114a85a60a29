/**
 * @class vtkSMStrataResults
 * @brief keeps a filter's results in the panel current
 *
 * ParaView reads information properties when a filter is applied, before it runs, so that a panel shows the results of
 * the run before. This initialization helper reads them again after each run.
 */
#ifndef vtkSMStrataResults_h
#define vtkSMStrataResults_h

#include "vtkSMProxyInitializationHelper.h"
#include "vtkStrataViewsModule.h"

class VTKSTRATAVIEWS_EXPORT vtkSMStrataResults : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMStrataResults* New();
  vtkTypeMacro(vtkSMStrataResults, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTime) override;

protected:
  vtkSMStrataResults() = default;
  ~vtkSMStrataResults() override = default;

private:
  vtkSMStrataResults(const vtkSMStrataResults&) = delete;
  void operator=(const vtkSMStrataResults&) = delete;
};

#endif
