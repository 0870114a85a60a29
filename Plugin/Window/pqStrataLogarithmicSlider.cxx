#include "pqStrataLogarithmicSlider.h"

#include <vtkCommand.h>
#include <vtkSMDomain.h>
#include <vtkSMDoubleRangeDomain.h>
#include <vtkSMIntRangeDomain.h>
#include <vtkSMProperty.h>

#include <QDoubleValidator>
#include <QHBoxLayout>
#include <QIntValidator>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int steps = 300; ///< a hundred for each of three decades
constexpr double decades = 1e3;
constexpr int digits = 3;
constexpr int narrow = 40; ///< pixels: ParaView's panel is narrow

vtkSMDomain* domainOf(vtkSMProperty* property)
{
  auto* doubles = property->FindDomain<vtkSMDoubleRangeDomain>();
  return doubles ? static_cast<vtkSMDomain*>(doubles) : property->FindDomain<vtkSMIntRangeDomain>();
}

struct Range
{
  double smallest = 0.0;
  double largest = 0.0;
};

/// The range that the property's domain knows now; zeros for none.
Range rangeOf(vtkSMProperty* property)
{
  int hasLow = 0;
  int hasHigh = 0;
  Range range;
  if (auto* domain = property->FindDomain<vtkSMDoubleRangeDomain>())
  {
    range = { domain->GetMinimum(0, hasLow), domain->GetMaximum(0, hasHigh) };
  }
  else if (auto* integers = property->FindDomain<vtkSMIntRangeDomain>())
  {
    const double low = integers->GetMinimum(0, hasLow);
    range = { low, static_cast<double>(integers->GetMaximum(0, hasHigh)) };
  }
  if (!hasHigh || !(range.largest > 0.0))
  {
    return {};
  }
  range.smallest = hasLow && range.smallest > 0.0 ? range.smallest : range.largest / decades;
  return range;
}
}

pqStrataLogarithmicSlider::pqStrataLogarithmicSlider(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent) :
  pqPropertyWidget(proxy, parent), property_(property), slider_(new QSlider(Qt::Horizontal, this)),
  line_(new QLineEdit(this))
{
  this->slider_->setObjectName("Slider");
  this->slider_->setRange(0, steps);
  this->slider_->setMinimumWidth(narrow);
  this->line_->setObjectName("LineEdit");
  this->line_->setMinimumWidth(narrow);
  if (property->FindDomain<vtkSMIntRangeDomain>())
  {
    this->line_->setValidator(new QIntValidator(this->line_));
  }
  else
  {
    this->line_->setValidator(new QDoubleValidator(this->line_));
  }
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->slider_, 3);
  layout->addWidget(this->line_, 2);

  this->readRange();
  this->connect(this->slider_, &QSlider::valueChanged, this, &pqStrataLogarithmicSlider::slid);
  this->connect(this->line_, &QLineEdit::textChanged, this, &pqStrataLogarithmicSlider::written);
  this->domain_ = domainOf(property);
  this->observer_ =
    this->domain_->AddObserver(vtkCommand::DomainModifiedEvent, this, &pqStrataLogarithmicSlider::readRange);
  this->addPropertyLink(this, "value", SIGNAL(valueChanged()), property);
  this->setChangeAvailableAsChangeFinished(true);
}

pqStrataLogarithmicSlider::~pqStrataLogarithmicSlider()
{
  if (this->domain_)
  {
    this->domain_->RemoveObserver(this->observer_);
  }
}

QString pqStrataLogarithmicSlider::value() const
{
  return this->line_->text();
}

void pqStrataLogarithmicSlider::setValue(const QString& text)
{
  this->line_->setText(text);
}

void pqStrataLogarithmicSlider::slid(int step)
{
  const double part = static_cast<double>(step) / steps;
  this->line_->setText(this->textOf(this->smallest_ * std::pow(this->largest_ / this->smallest_, part)));
}

void pqStrataLogarithmicSlider::written()
{
  this->placeSlider();
  if (this->line_->hasAcceptableInput())
  {
    Q_EMIT this->valueChanged();
  }
}

void pqStrataLogarithmicSlider::readRange()
{
  const Range range = rangeOf(this->property_);
  this->smallest_ = range.smallest;
  this->largest_ = range.largest;
  this->slider_->setEnabled(range.largest > range.smallest);
  this->placeSlider();
}

void pqStrataLogarithmicSlider::placeSlider()
{
  const double number = this->line_->text().toDouble();
  double part = 0.0;
  if (number > this->smallest_ && this->largest_ > this->smallest_)
  {
    part = std::log(number / this->smallest_) / std::log(this->largest_ / this->smallest_);
  }
  const QSignalBlocker blocker(this->slider_);
  this->slider_->setValue(static_cast<int>(std::lround(steps * std::min(part, 1.0))));
}

QString pqStrataLogarithmicSlider::textOf(double number) const
{
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - digits + 1);
  const double rounded = std::round(number / unit) * unit;
  const bool whole = this->property_->FindDomain<vtkSMIntRangeDomain>();
  return whole ? QString::number(std::llround(std::max(number < 1e3 ? number : rounded, this->smallest_)))
               : QString::number(number, 'g', digits);
}
