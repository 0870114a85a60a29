#include "vtkSMStrataResults.h"

#include "ProxyObserver.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkSMStrataResults);

void vtkSMStrataResults::PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType)
{
  ProxyObserver::watch(
    proxy, vtkCommand::UpdateDataEvent, proxy, [](vtkSMProxy* source, void*) { source->UpdatePropertyInformation(); });
}
