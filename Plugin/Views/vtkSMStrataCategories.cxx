#include "vtkSMStrataCategories.h"

#include "CategoryColors.h"
#include "ProxyObserver.h"

#include <vtkDataObject.h>
#include <vtkObjectFactory.h>
#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxyManager.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>

#include <cstring>

vtkStandardNewMacro(vtkSMStrataCategories);

namespace
{
vtkSMProxy* proxyOf(vtkSMProxy* owner, const char* property)
{
  return owner->GetProperty(property) ? vtkSMPropertyHelper(owner, property).GetAsProxy() : nullptr;
}

bool isNewViewOf(vtkSMProxy* source, const vtkSMProxyManager::RegisteredProxyInformation& registered)
{
  return registered.Type == vtkSMProxyManager::RegisteredProxyInformation::PROXY && registered.GroupName &&
         std::strcmp(registered.GroupName, "representations") == 0 && registered.Proxy &&
         !source->GetSessionProxyManager()->GetInLoadXMLState() && proxyOf(registered.Proxy, "Input") == source &&
         registered.Proxy->GetProperty("ColorArrayName");
}

bool hasCellArray(vtkSMProxy* source, const std::string& array)
{
  auto* producer = vtkSMSourceProxy::SafeDownCast(source);
  return producer && producer->GetDataInformation()->GetArrayInformation(array.c_str(), vtkDataObject::CELL);
}

/// False if the source has no categories or no cells yet; ParaView would warn of an array without a range.
bool colorByCategory(vtkSMProxy* view, vtkSMProxy* source, const std::string& array)
{
  source->UpdatePropertyInformation();
  const Categories categories = readCategories(vtkSMPropertyHelper(source, "Legend").GetAsString());
  if (categories.empty() || !hasCellArray(source, array))
  {
    return false;
  }
  vtkSMPVRepresentationProxy::SetScalarColoring(view, array.c_str(), vtkDataObject::CELL);
  vtkSMProxy* colorMap = proxyOf(view, "LookupTable");
  if (colorMap && !addCategories(colorMap, categories))
  {
    vtkSMPropertyHelper(view, "UseSeparateColorMap", true).Set(1);
    vtkSMPVRepresentationProxy::SetScalarColoring(view, array.c_str(), vtkDataObject::CELL);
    addCategories(proxyOf(view, "LookupTable"), categories);
  }
  return true;
}
}

void vtkSMStrataCategories::PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType)
{
  const std::string array = xml->GetAttributeOrEmpty("array");
  ProxyObserver::watch(
    proxy->GetSessionProxyManager(), vtkCommand::RegisterEvent, proxy, [array](vtkSMProxy* source, void* data) {
      const auto& registered = *static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
      if (!isNewViewOf(source, registered))
      {
        return;
      }
      // A view of a run that was aborted waits for the next.
      if (!colorByCategory(registered.Proxy, source, array))
      {
        ProxyObserver::watch(source, vtkCommand::UpdateDataEvent, registered.Proxy,
          [source, array, done = false](
            vtkSMProxy* view, void*) mutable { done = done || colorByCategory(view, source, array); });
      }
    });
}
