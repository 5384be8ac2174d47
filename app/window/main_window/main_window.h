#pragma once

#include "app/window/files/job_queue.h"
#include "app/window/files/recent_files.h"
#include "app/window/files/recovery.h"
#include "app/window/guide/actions.h"
#include "app/window/log/event_log.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/theme.h"
#include "app/window/toolkit/coalesced_refresh.h"
#include "app/window/toolkit/wheel_guard.h"
#include "widgets/coloring/scale_ranges.h"
#include "widgets/controls/selection.h"

#include <QImage>
#include <QMainWindow>
#include <memory>

namespace hexoderm {

class Panels;
struct Views;

/// The one window: it creates the controller, the views and the presenters that wire them, and lays the views out. What
/// a presenter does it does not know.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] SessionController& controller() { return controller_; }
  [[nodiscard]] Selection& selection() { return selection_; }
  [[nodiscard]] const WindowActions& actions() const { return actions_; }
  [[nodiscard]] EventLog& log() { return log_; }
  [[nodiscard]] Preferences& preferences() { return preferences_; }
  [[nodiscard]] RecentFiles& recentFiles() { return recent_; }
  [[nodiscard]] UnsavedSessions& unsavedSessions() { return unsaved_; }

  /// All ask first if poses would be lost.
  void openFile(const QString& path);
  void startDemo();
  void connectTo(const ConnectRequest& request);

  /// `remember`: also for the next start.
  void setThemeChoice(ThemeChoice choice, bool remember);
  [[nodiscard]] Theme theme() const;

  /// Shows at once what has changed, instead of in the next turn of the event loop.
  void showChanges() { refresh_.finish(); }

  /// The whole window as it looks now. Waits for the 3D view to be up to date.
  [[nodiscard]] QImage picture();

 signals:
  /// The window shows what has changed. Once a turn of the event loop at most, however much changes in it.
  void refreshed();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  // With the keyboard the window itself looks no different; QWidget's own would paint all that is in it anew.
  void focusInEvent(QFocusEvent* /*event*/) override {}
  void focusOutEvent(QFocusEvent* /*event*/) override {}

 private:
  struct Presenters;

  void layOut();
  [[nodiscard]] QWidget* makeTopBar();
  void scrollIfScreenIsSmall();
  void restoreLayout();
  void handOutResults();
  void connectRefresh();
  void refresh();

  WheelGuard wheel_guard_;
  SessionController controller_;
  Selection selection_;
  ScaleRanges scale_ranges_;
  WindowActions actions_;
  EventLog log_;
  Preferences preferences_;
  RecentFiles recent_;
  UnsavedSessions unsaved_;
  JobQueue jobs_;  ///< after those whose files it looks at: its thread has ended before they go
  CoalescedRefresh refresh_;
  std::unique_ptr<Views> views_;
  Panels* panels_;  ///< inside the window, so that banner and messages stay above them all
  std::unique_ptr<Presenters> presenters_;
};

}  // namespace hexoderm
