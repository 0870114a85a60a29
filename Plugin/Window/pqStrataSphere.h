#ifndef pqStrataSphere_h
#define pqStrataSphere_h

#include <pqSpherePropertyWidget.h>

/// ParaView's sphere, which is drawn in the view only while its part of the panel is seen.
class pqStrataSphere : public pqSpherePropertyWidget
{
  Q_OBJECT

public:
  pqStrataSphere(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqStrataSphere() override = default;

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
};

#endif
