#include "pqStrataSphere.h"

pqStrataSphere::pqStrataSphere(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent) :
  pqSpherePropertyWidget(proxy, group, parent)
{
  this->setWidgetVisible(false);
}

void pqStrataSphere::showEvent(QShowEvent* event)
{
  pqSpherePropertyWidget::showEvent(event);
  this->setWidgetVisible(true);
}

void pqStrataSphere::hideEvent(QHideEvent* event)
{
  pqSpherePropertyWidget::hideEvent(event);
  this->setWidgetVisible(false);
}
