#ifndef pqStrataMaterialList_h
#define pqStrataMaterialList_h

#include <pqPropertyWidget.h>

/// The materials of the input, to be ticked: for a list of names whose domain is a StringListDomain. ParaView itself
/// has such lists for arrays only. None ticked leaves the list empty.
class pqStrataMaterialList : public pqPropertyWidget
{
  Q_OBJECT

public:
  pqStrataMaterialList(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqStrataMaterialList() override = default;
};

#endif
