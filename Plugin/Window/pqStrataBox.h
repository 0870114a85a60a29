#ifndef pqStrataBox_h
#define pqStrataBox_h

#include <pqInteractivePropertyWidget.h>

#include <array>

class QLineEdit;

/// A box along the axes for a property of six numbers (smallest and largest x, y and z), the group's function Bounds: a
/// box in the view, drawn while this part of the panel is seen, and six lines. It can be moved and stretched, not
/// turned.
class pqStrataBox : public pqInteractivePropertyWidget
{
  Q_OBJECT

public:
  pqStrataBox(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqStrataBox() override = default;

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

protected Q_SLOTS:
  void placeWidget() override;

private Q_SLOTS:
  void readBox();
  void drawBox();
  void takeWholeData();

private:
  std::array<QLineEdit*, 6> lines_;
  bool reading_ = false;
};

#endif
