#include "pqStrataAbort.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqProgressManager.h>
#include <pqServerManagerModel.h>
#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkSMProxy.h>

#include <QAbstractButton>
#include <QCoreApplication>
#include <QMouseEvent>

#include <cstring>

namespace
{
constexpr std::chrono::milliseconds readingInterval{ 100 };
/// A press takes several turns of the event loop: from the display's queue to the window, from there to the button.
constexpr int turns = 8;

pqProgressManager* progressManager()
{
  return pqApplicationCore::instance()->getProgressManager();
}

/// The status bar's button; it is one of the few widgets that may be used while ParaView is busy.
QAbstractButton* abortButton()
{
  for (const QPointer<QObject>& object : progressManager()->nonBlockableObjects())
  {
    auto* button = qobject_cast<QAbstractButton*>(object.data());
    if (button && button->objectName() == "AbortButton")
    {
      return button;
    }
  }
  return nullptr;
}

bool isMouse(QEvent* event)
{
  const QEvent::Type type = event->type();
  return type == QEvent::MouseButtonPress || type == QEvent::MouseButtonRelease ||
         type == QEvent::MouseButtonDblClick || type == QEvent::MouseMove;
}

/// What would change the window's state, or run further code, in the middle of a filter.
bool mustWait(QEvent::Type type)
{
  switch (type)
  {
    case QEvent::Timer:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::Shortcut:
    case QEvent::ShortcutOverride:
    case QEvent::Wheel:
    case QEvent::ContextMenu:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
    case QEvent::NativeGesture:
    case QEvent::DragEnter:
    case QEvent::DragMove:
    case QEvent::Drop:
    case QEvent::Close:
    case QEvent::Quit:
      return true;
    default:
      return false;
  }
}
}

pqStrataAbort::pqStrataAbort(QObject* parent) : QObject(parent)
{
  this->observer_->SetCallback(pqStrataAbort::onEvent);
  this->observer_->SetClientData(this);
}

pqStrataAbort::~pqStrataAbort() = default;

void pqStrataAbort::startup()
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, &pqServerManagerModel::sourceAdded, this, &pqStrataAbort::watch);
  for (pqPipelineSource* source : model->findItems<pqPipelineSource*>())
  {
    this->watch(source);
  }
  this->connect(progressManager(), &pqProgressManager::abort, this, &pqStrataAbort::abort);
}

void pqStrataAbort::shutdown()
{
  // Filters may outlive this object.
  this->observer_->SetClientData(nullptr);
}

void pqStrataAbort::watch(pqPipelineSource* source)
{
  // Nothing with a remote server, where the filter lives.
  auto* filter = vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
  if (!filter || std::strncmp(filter->GetClassName(), "vtkStrata", 9) != 0)
  {
    return;
  }
  for (const unsigned long event : { vtkCommand::StartEvent, vtkCommand::ProgressEvent, vtkCommand::EndEvent })
  {
    filter->AddObserver(event, this->observer_);
  }
}

void pqStrataAbort::onEvent(vtkObject* caller, unsigned long event, void* data, void*)
{
  auto* self = static_cast<pqStrataAbort*>(data);
  if (!self || self->reading_)
  {
    return;
  }
  if (event == vtkCommand::StartEvent)
  {
    self->begin(vtkAlgorithm::SafeDownCast(caller));
  }
  else if (event == vtkCommand::EndEvent)
  {
    self->end();
  }
  else if (self->running_ && std::chrono::steady_clock::now() - self->last_ > readingInterval)
  {
    self->readEvents();
    self->last_ = std::chrono::steady_clock::now();
  }
}

void pqStrataAbort::begin(vtkAlgorithm* filter)
{
  this->running_ = filter;
  this->button_ = abortButton();
  this->last_ = std::chrono::steady_clock::now();
  progressManager()->setEnableAbort(true);
}

void pqStrataAbort::end()
{
  this->running_ = nullptr;
  progressManager()->setEnableAbort(false);
}

void pqStrataAbort::abort()
{
  if (this->running_)
  {
    this->running_->SetAbortExecute(1);
  }
}

void pqStrataAbort::readEvents()
{
  this->reading_ = true;
  QCoreApplication::instance()->installEventFilter(this);
  // ParaView's own filter takes a press for the window that holds the button and drops it.
  const bool before = progressManager()->unblockEvents(true);
  for (int turn = 0; turn < turns; ++turn)
  {
    QCoreApplication::processEvents(QEventLoop::ExcludeSocketNotifiers);
  }
  progressManager()->unblockEvents(before);
  QCoreApplication::instance()->removeEventFilter(this);
  this->reading_ = false;
}

bool pqStrataAbort::eventFilter(QObject* receiver, QEvent* event)
{
  return !this->mayReceive(receiver, event);
}

bool pqStrataAbort::mayReceive(QObject* receiver, QEvent* event) const
{
  if (isMouse(event))
  {
    // The window gets it first, then the widget under the mouse.
    const QPoint place = static_cast<QMouseEvent*>(event)->globalPos();
    return this->button_ && (receiver == this->button_ || receiver->isWindowType()) &&
           this->button_->rect().contains(this->button_->mapFromGlobal(place));
  }
  if (event->type() == QEvent::Close)
  {
    event->ignore();
  }
  return !mustWait(event->type());
}
