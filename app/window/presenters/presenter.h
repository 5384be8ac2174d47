#pragma once

#include "app/window/guide/actions.h"
#include "app/window/log/event_log.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "app/window/views/panels.h"
#include "app/window/views/views.h"

#include <QCoreApplication>
#include <QObject>

namespace hexoderm {

class OncePerTurn;
class RecentFiles;
class ScaleRanges;
class UnsavedSessions;

/// What the presenters wire: the window, its views and panels, and what these show. All outlive the presenters.
struct WindowParts {
  QWidget& window;  ///< dialogs belong to it
  const Views& views;
  Panels& panels;
  OncePerTurn& refresh;  ///< of the window
  SessionController& controller;
  WindowActions& actions;
  Selection& selection;
  ScaleRanges& scale_ranges;
  Preferences& preferences;
  EventLog& log;
  RecentFiles& recent;
  UnsavedSessions& unsaved;
};

/// Wires the session and the views, as far as one duty goes.
class Presenter : public QObject {
 public:
  /// Shows what has changed, once a turn of the event loop at most. The actions know already which of them can be used.
  virtual void refresh() {}

 protected:
  explicit Presenter(const WindowParts& parts)
      : window_(parts.window),
        views_(parts.views),
        panels_(parts.panels),
        refresh_(parts.refresh),
        controller_(parts.controller),
        actions_(parts.actions),
        selection_(parts.selection),
        preferences_(parts.preferences),
        log_(parts.log) {}

  QWidget& window_;
  const Views& views_;
  Panels& panels_;
  OncePerTurn& refresh_;
  SessionController& controller_;
  WindowActions& actions_;
  Selection& selection_;
  Preferences& preferences_;
  EventLog& log_;
};

}  // namespace hexoderm
