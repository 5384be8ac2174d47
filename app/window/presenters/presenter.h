#pragma once

#include "app/window/guide/actions.h"
#include "app/window/log/event_log.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "app/window/toolkit/dialogs.h"
#include "app/window/views/panels.h"
#include "app/window/views/views.h"

#include <QCoreApplication>
#include <QObject>
#include <functional>

namespace hexoderm {

class CoalescedRefresh;
class RecentFiles;
class ScaleRanges;
class UnsavedSessions;

/// What the presenters wire: the window, its views and panels, and what these show. All outlive the presenters.
struct WindowParts {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::WindowParts)

 public:
  QObject& wires;   ///< the receiver of connections of functions: it ends with the presenters
  QWidget& window;  ///< dialogs belong to it
  const Views& views;
  Panels& panels;
  CoalescedRefresh& coalesced_refresh;  ///< refreshes the window
  SessionController& controller;
  WindowActions& actions;
  Selection& selection;
  ScaleRanges& scale_ranges;
  Preferences& preferences;
  EventLog& log;
  RecentFiles& recent;
  UnsavedSessions& unsaved;

  /// Asks for a file to be read, at first in the folder of the last one.
  void askToRead(const char* name, const QString& title, const QString& filter,
                 const std::function<void(const QString&)>& take) const {
    askForFile(&window, name, title, lastFolder(), filter, &wires, [take](const QString& path) {
      rememberFolder(path);
      take(path);
    });
  }
};

/// Wires the session and the views, as far as one duty goes that has a state of its own; the others are functions
/// (presenters.h).
class Presenter : public QObject, protected WindowParts {
 protected:
  explicit Presenter(const WindowParts& parts) : WindowParts(parts) {}
};

}  // namespace hexoderm
