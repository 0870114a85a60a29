#include "pqStrataMaterialList.h"

#include <pqArrayListDomain.h>
#include <pqArraySelectionWidget.h>
#include <vtkSMProperty.h>
#include <vtkSMProxy.h>
#include <vtkSMStringListDomain.h>

#include <QVBoxLayout>

pqStrataMaterialList::pqStrataMaterialList(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent) :
  pqPropertyWidget(proxy, parent)
{
  const QString name = proxy->GetPropertyName(property);
  auto* list = new pqArraySelectionWidget(this);
  list->setObjectName("ArraySelectionWidget");
  list->setHeaderLabel(property->GetXMLLabel());
  list->setMaximumRowCountBeforeScrolling(pqPropertyWidget::hintsWidgetHeightNumberOfRows(property->GetHints()));

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(list);

  // The object lives as long as the list, which it fills anew when the materials change.
  new pqArrayListDomain(list, name, proxy, property, property->FindDomain<vtkSMStringListDomain>());
  this->addPropertyLink(list, name.toUtf8().data(), SIGNAL(widgetModified()), property);
  this->setChangeAvailableAsChangeFinished(true);
  this->setShowLabel(false);
}
