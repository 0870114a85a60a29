#ifndef pqStrataAbort_h
#define pqStrataAbort_h

#include <QObject>
#include <QPointer>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

#include <chrono>

class QAbstractButton;
class pqPipelineSource;
class vtkAlgorithm;
class vtkCallbackCommand;
class vtkObject;

/// Makes the abort button of ParaView's window stop Strata's filters.
///
/// ParaView 5.11 has the button, but enables it for nothing and reads no events while a filter runs. While one of
/// Strata's filters runs in the window's own process, this object enables the button and reads events at the filter's
/// progress, at most ten times a second. Only what the button needs goes through; all other input is dropped, as
/// ParaView does while it is busy, and timers wait. A press sets the filter's AbortExecute. With a remote server the
/// button stays grey.
class pqStrataAbort : public QObject
{
  Q_OBJECT

public:
  explicit pqStrataAbort(QObject* parent = nullptr);
  ~pqStrataAbort() override;

  void startup();
  void shutdown();

  bool eventFilter(QObject* receiver, QEvent* event) override;

private Q_SLOTS:
  void watch(pqPipelineSource* source);
  void abort();

private:
  static void onEvent(vtkObject* caller, unsigned long event, void* self, void* data);
  void begin(vtkAlgorithm* filter);
  void end();
  void readEvents();
  bool mayReceive(QObject* receiver, QEvent* event) const;

  vtkNew<vtkCallbackCommand> observer_;
  vtkWeakPointer<vtkAlgorithm> running_;
  QPointer<QAbstractButton> button_;
  std::chrono::steady_clock::time_point last_;
  bool reading_ = false;
};

#endif
