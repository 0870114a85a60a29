#include "vtkSMStrataCategories.h"

#include "CategoryColors.h"
#include "ProxyObserver.h"

#include <vtkDataObject.h>
#include <vtkObjectFactory.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxyManager.h>
#include <vtkSMSessionProxyManager.h>

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

void colorByCategory(vtkSMProxy* view, const Categories& categories, const char* array)
{
  vtkSMPVRepresentationProxy::SetScalarColoring(view, array, vtkDataObject::CELL);
  vtkSMProxy* colorMap = proxyOf(view, "LookupTable");
  if (!colorMap || addCategories(colorMap, categories))
  {
    return;
  }
  vtkSMPropertyHelper(view, "UseSeparateColorMap", true).Set(1);
  vtkSMPVRepresentationProxy::SetScalarColoring(view, array, vtkDataObject::CELL);
  addCategories(proxyOf(view, "LookupTable"), categories);
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
      source->UpdatePropertyInformation();
      const Categories categories = readCategories(vtkSMPropertyHelper(source, "Legend").GetAsString());
      if (!categories.empty())
      {
        colorByCategory(registered.Proxy, categories, array.c_str());
      }
    });
}
