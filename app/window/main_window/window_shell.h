#pragma once

#include "app/window/files/job_queue.h"
#include "app/window/files/recent_files.h"
#include "app/window/files/recovery.h"
#include "app/window/log/event_log.h"
#include "app/window/settings/preferences.h"

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

class QMenuBar;
class QWidget;

namespace hexoderm {

class CardDock;
class MessageBar;
class SessionController;
class WindowActions;
struct Step;

/// What surrounds the steps: the log, recent and unsaved sessions, preferences, the list of keys, the welcome, and
/// which of the two big views is in the middle. Part of the main window, which outlives it.
class WindowShell : public QObject {
  Q_OBJECT

 public:
  /// What it works with; all outlive the shell.
  struct Window {
    QWidget& window;
    SessionController& controller;
    WindowActions& actions;
    MessageBar& messages;
    std::function<void(QString)> open_file;      ///< as the main window does, which asks to save first
    std::function<void(ThemeChoice)> set_theme;  ///< and remembers it
    std::function<ThemeChoice()> theme_in_force;
  };
  explicit WindowShell(Window window);
  ~WindowShell() override;

  [[nodiscard]] EventLog& log() { return log_; }
  [[nodiscard]] Preferences& preferences() { return preferences_; }
  [[nodiscard]] RecentFiles& recentFiles() { return recent_; }
  [[nodiscard]] UnsavedSessions& unsavedSessions() { return unsaved_; }

  /// For the panels below: the log with its buttons.
  [[nodiscard]] QWidget* makeLogView();
  /// For the step "Connect": recent and unsaved sessions, as long as the welcome does not show them.
  [[nodiscard]] QWidget* makeConnectBody();
  /// The middle of the window: `patch_view` and above it, while nothing is open, the welcome.
  [[nodiscard]] QWidget* makeCentre(QWidget* patch_view);
  /// The two views that G swaps, and the dock of the second.
  void setSwapped(QWidget* patch_view, QWidget* graph_view, CardDock* graph_dock);

  /// When the window is built: connects it all, and looks for sessions that were not saved.
  void begin(QMenuBar& menus);
  void setSteps(const std::vector<Step>& steps);

  void copyReport();

 private:
  void connectActions(QMenuBar& menus);
  void connectLog();
  void connectRecent();
  void connectRecovery();
  void connectPreferences();
  void offerSoftwareOpenGl();
  void openLogFolder();
  void showPreferences();
  void showWelcome();
  void noteOpen();
  void swapViews(bool remember);

  Window window_;
  EventLog log_;
  Preferences preferences_;
  QString source_state_;  ///< last written to the log
  QWidget* welcome_ = nullptr;
  QWidget* connect_body_ = nullptr;
  QWidget* patch_view_ = nullptr;
  QWidget* graph_view_ = nullptr;
  CardDock* graph_dock_ = nullptr;
  RecentFiles recent_;
  UnsavedSessions unsaved_;
  JobQueue jobs_;  // last: its thread has ended before anything it reports to goes
};

}  // namespace hexoderm
