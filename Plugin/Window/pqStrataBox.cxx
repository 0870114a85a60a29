#include "pqStrataBox.h"

#include <pqDoubleLineEdit.h>
#include <vtkBoundingBox.h>
#include <vtkSMNewWidgetRepresentationProxy.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyGroup.h>
#include <vtkSMPropertyHelper.h>

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace
{
QString textOf(double number)
{
  return QString::number(number, 'g', 10);
}
}

pqStrataBox::pqStrataBox(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent) :
  pqInteractivePropertyWidget("representations", "BoxWidgetRepresentation", proxy, group, parent)
{
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  vtkSMProperty* bounds = group->GetProperty("Bounds");
  for (int i = 0; i < 6; ++i)
  {
    auto* line = new pqDoubleLineEdit(this);
    line->setObjectName(QString("bound%1").arg(i));
    this->lines_[static_cast<std::size_t>(i)] = line;
    grid->addWidget(line, i / 2, 1 + i % 2);
    this->addPropertyLink(line, "text2", SIGNAL(textChanged(const QString&)), bounds, i);
    this->connect(line, &pqDoubleLineEdit::textChangedAndEditingFinished, this, &pqStrataBox::drawBox);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    grid->addWidget(new QLabel(QString("XYZ").mid(axis, 1), this), axis, 0);
  }
  auto* whole = new QPushButton("Whole data", this);
  whole->setObjectName("wholeData");
  grid->addWidget(whole, 3, 1, 1, 2);
  this->connect(whole, &QPushButton::clicked, this, &pqStrataBox::takeWholeData);

  vtkSMProxy* box = this->widgetProxy();
  vtkSMPropertyHelper(box, "RotationEnabled").Set(0);
  const double unit[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  vtkSMPropertyHelper(box, "ReferenceBounds").Set(unit, 6);
  vtkSMPropertyHelper(box, "UseReferenceBounds").Set(1);
  box->UpdateVTKObjects();
  this->connect(this, &pqStrataBox::interaction, this, &pqStrataBox::readBox);
  this->connect(this, &pqStrataBox::endInteraction, this, &pqStrataBox::readBox);
  this->setWidgetVisible(false);
}

void pqStrataBox::showEvent(QShowEvent* event)
{
  pqInteractivePropertyWidget::showEvent(event);
  this->drawBox();
  this->setWidgetVisible(true);
}

void pqStrataBox::hideEvent(QHideEvent* event)
{
  pqInteractivePropertyWidget::hideEvent(event);
  this->setWidgetVisible(false);
}

void pqStrataBox::placeWidget()
{
  this->drawBox();
}

void pqStrataBox::readBox()
{
  vtkSMProxy* box = this->widgetProxy();
  box->UpdatePropertyInformation();
  const vtkSMPropertyHelper position(box, "PositionInfo");
  const vtkSMPropertyHelper size(box, "ScaleInfo");
  this->reading_ = true;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double one = position.GetAsDouble(axis);
    const double other = one + size.GetAsDouble(axis);
    this->lines_[2 * axis]->setText(textOf(std::min(one, other)));
    this->lines_[2 * axis + 1]->setText(textOf(std::max(one, other)));
  }
  this->reading_ = false;
  Q_EMIT this->changeAvailable();
}

void pqStrataBox::drawBox()
{
  if (this->reading_)
  {
    return;
  }
  vtkSMProxy* box = this->widgetProxy();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double low = this->lines_[2 * axis]->text().toDouble();
    vtkSMPropertyHelper(box, "Position").Set(axis, low);
    vtkSMPropertyHelper(box, "Scale").Set(axis, this->lines_[2 * axis + 1]->text().toDouble() - low);
  }
  box->UpdateVTKObjects();
  this->render();
}

void pqStrataBox::takeWholeData()
{
  const vtkBoundingBox data = this->dataBounds();
  for (int i = 0; data.IsValid() && i < 6; ++i)
  {
    this->lines_[static_cast<std::size_t>(i)]->setText(textOf(data.GetBound(i)));
  }
  this->drawBox();
}
