#ifndef pqStrataLogarithmicSlider_h
#define pqStrataLogarithmicSlider_h

#include <pqPropertyWidget.h>
#include <vtkSMDomain.h>
#include <vtkWeakPointer.h>

class QLineEdit;
class QSlider;

/// A number with a slider on which equal steps are equal factors, and a line in which any number can be written.
///
/// The slider spans the property's range. Where that begins at zero, or has no begin, it spans three decades below its
/// end; zero, which stands for a default, then lies at the slider's left end.
class pqStrataLogarithmicSlider : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QString value READ value WRITE setValue NOTIFY valueChanged)

public:
  pqStrataLogarithmicSlider(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqStrataLogarithmicSlider() override;

  QString value() const;
  void setValue(const QString& text);

Q_SIGNALS:
  void valueChanged();

private Q_SLOTS:
  void slid(int step);
  void written();

private:
  void readRange();
  void placeSlider();
  QString textOf(double number) const;

  vtkSMProperty* property_;
  vtkWeakPointer<vtkSMDomain> domain_;
  unsigned long observer_ = 0;
  QSlider* slider_;
  QLineEdit* line_;
  double smallest_ = 0.0;
  double largest_ = 0.0;
};

#endif
