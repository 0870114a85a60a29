#ifndef ProxyObserver_h
#define ProxyObserver_h

#include <vtkCommand.h>
#include <vtkSMProxy.h>
#include <vtkWeakPointer.h>

#include <functional>
#include <utility>

/// Calls a function with a proxy, as long as that lives, and what an event brings along.
class ProxyObserver : public vtkCommand
{
public:
  using Call = std::function<void(vtkSMProxy*, void*)>;

  /// Watches `subject`. Where that outlives the proxy, the observer removes itself at the first event after its end.
  static void watch(vtkObject* subject, unsigned long event, vtkSMProxy* proxy, Call call)
  {
    auto* observer = new ProxyObserver;
    observer->proxy_ = proxy;
    observer->call_ = std::move(call);
    subject->AddObserver(event, observer);
    observer->Delete();
  }

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    if (this->proxy_)
    {
      this->call_(this->proxy_, data);
    }
    else
    {
      caller->RemoveObserver(this);
    }
  }

private:
  vtkWeakPointer<vtkSMProxy> proxy_;
  Call call_;
};

#endif
