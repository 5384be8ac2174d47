#include "app/window/main_window/window_shell.h"

#include "app/window/files/session_paths.h"
#include "app/window/guide/actions.h"
#include "app/window/guide/keys_dialog.h"
#include "app/window/guide/welcome_panel.h"
#include "app/window/log/bug_report.h"
#include "app/window/log/log_view.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences_dialog.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "widgets/capture/live_strip.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/step_panel.h"
#include "widgets/patch/scene_widget.h"
#include "widgets/words/core_words.h"
#include "widgets/words/formatting.h"

#include <QApplication>
#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QMenuBar>
#include <QSettings>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>
#include <utility>

namespace hexoderm {
namespace {

const QString kSwapped = QStringLiteral("window/swapped");

Severity severityOf(Tone tone) {
  switch (tone) {
    case Tone::Neutral:
    case Tone::Good:
      return Severity::Info;
    case Tone::Caution:
      return Severity::Warning;
    case Tone::Bad:
      return Severity::Error;
  }
  return Severity::Info;
}

/// One line on a result: how large, how, how long, how good.
QString resultInWords(const Reconstruction& result) {
  return WindowShell::tr("Solved: %1, %2, %3, %4 ms. %5")
      .arg(coreWords(sizeInWords(result)), posesInWords(result.poses.size()), QString::fromStdString(result.solver),
           figureInWords(1e3 * result.solve_seconds, 1), coreWords(result.verdict.reason));
}

}  // namespace

WindowShell::WindowShell(Window window)
    : window_(std::move(window)), log_(logFolder()), recent_(jobs_), unsaved_(jobs_, unsavedFolder()) {
  log_.add(Severity::Info, tr("Hexoderm %1 starts").arg(QLatin1String(HEXODERM_VERSION)));
}

WindowShell::~WindowShell() = default;

QWidget* WindowShell::makeLogView() {
  auto* view = new LogView(log_);
  connect(view, &LogView::reportWanted, this, &WindowShell::copyReport);
  connect(view, &LogView::folderWanted, this, &WindowShell::openLogFolder);
  return view;
}

QWidget* WindowShell::makeConnectBody() {
  connect_body_ = new QWidget;
  auto* layout = new QVBoxLayout(connect_body_);
  layout->setContentsMargins(0, 8, 0, 0);
  layout->addWidget(new RecoveryList(unsaved_));
  auto* title = new QLabel(tr("Recent").toUpper());
  title->setProperty("caption", true);
  layout->addWidget(title);
  constexpr std::size_t kShown = 3;
  constexpr int kTitleCharacters = 22;
  auto* recent = new RecentList(recent_, kShown, kTitleCharacters);
  connect(recent, &RecentList::openWanted, this, [this](const QString& path) { window_.open_file(path); });
  layout->addWidget(recent);
  return connect_body_;
}

QWidget* WindowShell::makeCentre(QWidget* patch_view) {
  const WindowActions& actions = window_.actions;
  auto* welcome = new WelcomePanel({actions.demo, actions.connect_skin, actions.open}, recent_, unsaved_);
  connect(welcome, &WelcomePanel::openWanted, this, [this](const QString& path) { window_.open_file(path); });
  welcome_ = welcome;
  auto* place = new QWidget;
  auto* place_layout = new QVBoxLayout(place);
  place_layout->setContentsMargins(0, 0, 0, 0);
  place_layout->addWidget(patch_view);
  // One above the other, so that the 3D view gets its graphics ready while nobody waits for it.
  auto* centre = new QWidget;
  auto* layout = new QGridLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(place, 0, 0);
  layout->addWidget(welcome, 0, 0);
  welcome->raise();
  return centre;
}

void WindowShell::setSwapped(QWidget* patch_view, QWidget* graph_view, CardDock* graph_dock) {
  patch_view_ = patch_view;
  graph_view_ = graph_view;
  graph_dock_ = graph_dock;
  if (QSettings().value(kSwapped, false).toBool()) swapViews(false);
}

void WindowShell::swapViews(bool remember) {
  QWidget* of_patch = patch_view_->parentWidget();
  QWidget* of_graph = graph_view_->parentWidget();
  of_patch->layout()->removeWidget(patch_view_);
  of_graph->layout()->removeWidget(graph_view_);
  of_patch->layout()->addWidget(graph_view_);
  of_graph->layout()->addWidget(patch_view_);
  graph_view_->show();
  patch_view_->show();
  const bool swapped = graph_dock_->isAncestorOf(patch_view_);
  graph_dock_->setHeading(swapped ? tr("Skin patch") : tr("Skin graph"));
  graph_view_->setAccessibleName(tr("Skin graph"));
  patch_view_->setAccessibleName(tr("The patch in three dimensions"));
  if (welcome_) welcome_->raise();
  if (remember) QSettings().setValue(kSwapped, swapped);
}

void WindowShell::begin(QMenuBar& menus) {
  connectActions(menus);
  connectLog();
  connectRecent();
  connectRecovery();
  connectPreferences();
  connect(&window_.controller, &SessionController::changed, this, &WindowShell::showWelcome);
  showWelcome();
  // When the window is there, and can say so.
  QTimer::singleShot(0, this, &WindowShell::offerSoftwareOpenGl);
}

void WindowShell::connectActions(QMenuBar& menus) {
  WindowActions& actions = window_.actions;
  connect(actions.preferences, &QAction::triggered, this, &WindowShell::showPreferences);
  connect(actions.copy_report, &QAction::triggered, this, &WindowShell::copyReport);
  connect(actions.open_log_folder, &QAction::triggered, this, &WindowShell::openLogFolder);
  connect(actions.swap_views, &QAction::triggered, this, [this] { swapViews(true); });
  connect(actions.keys, &QAction::triggered, this, [this, &menus] { showKeysDialog(&window_.window, menus); });
}

void WindowShell::setSteps(const std::vector<Step>& steps) {
  const std::vector<QAction*>& actions = window_.actions.go_to_step;
  for (std::size_t k = 0; k < actions.size(); ++k) {
    const bool is_there = k < steps.size();
    actions[k]->setVisible(is_there);
    actions[k]->setEnabled(is_there);
    if (is_there) actions[k]->setText(tr("Step &%1: %2").arg(k + 1).arg(steps[k].title));
  }
}

void WindowShell::connectLog() {
  const SessionController& controller = window_.controller;
  connect(&log_, &EventLog::fileFailed, this, [this](const QString& why) {
    window_.messages.showMessage(Tone::Caution, tr("The log is kept in memory only. %1").arg(why));
  });
  // What the operator was told.
  connect(&window_.messages, &MessageBar::shown, this,
          [this](Tone tone, const QString& text) { log_.add(severityOf(tone), text); });
  // What they did.
  for (QAction* action : window_.window.actions()) {
    connect(action, &QAction::triggered, this, [this, action] {
      log_.add(Severity::Info, tr("Asked for: %1").arg(action->text().remove(QLatin1Char('&'))));
    });
  }
  // What became of it.
  connect(&controller, &SessionController::opened, this,
          [this](const QString& name) { log_.add(Severity::Info, tr("Opened %1").arg(name)); });
  connect(&controller, &SessionController::reconstructionChanged, this,
          [this](const std::shared_ptr<const Reconstruction>& result) {
            if (result) log_.add(Severity::Info, resultInWords(*result));
          });
  connect(&controller.liveSession().source(), &LiveSource::statusChanged, this, [this] {
    const LiveSource& live = window_.controller.liveSession().source();
    const QString state = sourceStateWord(live.status().state);
    // The text counts readings; only what becomes of the connection is news.
    if (state == source_state_) return;
    source_state_ = state;
    const bool is_bad = live.status().state == SourceState::Silent || live.status().state == SourceState::Incompatible;
    log_.add(is_bad ? Severity::Warning : Severity::Info,
             tr("Skin at %1: %2. %3").arg(live.address(), state, coreWords(live.status().text)));
  });
}

void WindowShell::connectRecent() {
  recent_.serve(window_.actions.recent, [this](const QString& path) { window_.open_file(path); });
  const SessionController& controller = window_.controller;
  connect(&controller, &SessionController::opened, this, &WindowShell::noteOpen);
  connect(&controller.file(), &SessionFile::sessionSaved, this, [this](const QString& path) {
    const Session* session = window_.controller.session();
    recent_.note(path, session ? static_cast<int>(session->poses().size()) : -1);
  });
  // So that the list says how many poses there are now.
  connect(&controller, &SessionController::reconstructionChanged, this, [this] {
    const Session* session = window_.controller.session();
    const QString path = window_.controller.file().sessionPath();
    if (!session || path.isEmpty() || recent_.files().empty()) return;
    const RecentFile& newest = recent_.files().front();
    const auto poses = static_cast<int>(session->poses().size());
    if (newest.path == QDir::cleanPath(QFileInfo(path).absoluteFilePath()) && newest.poses != poses) {
      recent_.note(path, poses);
    }
  });
  recent_.check();
}

void WindowShell::noteOpen() {
  const SessionController& controller = window_.controller;
  const QString path = controller.session() ? controller.file().sessionPath() : controller.file().calibrationPath();
  if (path.isEmpty() || isInUnsavedFolder(path)) return;
  recent_.note(path, controller.session() ? static_cast<int>(controller.session()->poses().size()) : -1);
}

void WindowShell::connectRecovery() {
  connect(&unsaved_, &UnsavedSessions::recoverWanted, this, [this](const QString& path) { window_.open_file(path); });
  connect(&window_.controller, &SessionController::opened, this,
          [this] { unsaved_.noteOpened(window_.controller.file().sessionPath()); });
  connect(&unsaved_, &UnsavedSessions::failed, this,
          [this](const QString& message) { window_.messages.showMessage(Tone::Bad, message); });
  connect(&unsaved_, &UnsavedSessions::found, this, [this](int count) {
    if (count == 0) return;
    const UnsavedSession newest = unsaved_.all().front();
    log_.add(Severity::Info, count == 1 ? tr("One session was not saved: %1").arg(newest.path)
                                        : tr("%1 sessions were not saved. The newest: %2").arg(count).arg(newest.path));
    // Who began with something else has not seen the welcome, which says it too.
    if ((window_.controller.isEmpty() && window_.controller.work().activity().isEmpty()) || !newest.problem.isEmpty())
      return;
    window_.messages.showMessage(Tone::Caution, describeUnsaved(newest), tr("Recover"), [this, path = newest.path] {
      window_.messages.hide();
      unsaved_.recover(path);
    });
  });
  unsaved_.search();
}

void WindowShell::connectPreferences() {
  SessionController& controller = window_.controller;
  controller.setSolverOptions(preferences_.solverOptions());
  controller.liveSession().setRecorderOptions(preferences_.recorderOptions());
  connect(&preferences_, &Preferences::solverOptionsChanged, &controller, &SessionController::setSolverOptions);
  connect(&preferences_, &Preferences::recorderOptionsChanged, &controller.liveSession(),
          &LiveSession::setRecorderOptions);
  connect(&preferences_, &Preferences::textFactorChanged, this, [this](double factor) {
    applyTextFactor(factor);
    // The style sheet's sizes follow the application's; in a turn of the event loop of their own.
    QTimer::singleShot(1, this, [this] { window_.set_theme(window_.theme_in_force()); });
  });
}

void WindowShell::showPreferences() {
  if (auto* open = window_.window.findChild<PreferencesDialog*>()) {
    open->raise();
    open->activateWindow();
    return;
  }
  auto* dialog = new PreferencesDialog(preferences_, window_.theme_in_force(), &window_.window);
  connect(dialog, &PreferencesDialog::themeChosen, this, [this, dialog](ThemeChoice choice) {
    window_.set_theme(choice);
    dialog->showTheme(choice);
  });
  connect(window_.actions.themes, &QActionGroup::triggered, dialog,
          [this, dialog] { dialog->showTheme(window_.theme_in_force()); });
  openInTurns(dialog, Qt::NonModal);
}

void WindowShell::offerSoftwareOpenGl() {
  if (window_.window.findChild<SceneWidget*>()) return;
  const bool tried = qEnvironmentVariableIsSet("LIBGL_ALWAYS_SOFTWARE");
  const QString what = tr("There is no OpenGL 3.2 here, so the 3D view is empty; graph and tables work.");
  if (tried) {
    window_.messages.showMessage(Tone::Caution, tr("%1 Drawing by the processor did not help either.").arg(what));
    return;
  }
  window_.messages.showMessage(Tone::Caution, what, tr("Draw without the graphics card"), [this] {
    preferences_.setSoftwareOpenGl(true);
    window_.messages.showMessage(Tone::Neutral, tr("From the next start on, the processor draws. Start Hexoderm again "
                                                   "when it suits you."));
  });
}

void WindowShell::showWelcome() {
  const bool is_welcome = window_.controller.isEmpty() && !window_.controller.liveSession().source().isRunning();
  // Who chose by a key what is opened goes on with keys that mean what the list of keys says, not with a neighbour.
  if (welcome_ && !is_welcome && welcome_->isAncestorOf(QApplication::focusWidget())) window_.window.setFocus();
  if (welcome_) welcome_->setVisible(is_welcome);
  // Beside what ends a connection, files would look like part of it.
  if (connect_body_) connect_body_->setVisible(!is_welcome && !window_.controller.liveSession().source().isRunning());
}

void WindowShell::copyReport() {
  QGuiApplication::clipboard()->setText(composeBugReport(log_, window_.controller, window_.window));
  window_.messages.showMessage(
      Tone::Good, tr("Copied: versions, graphics, what is open and the last lines of the log, with your home "
                     "folder as ~. Paste it into the report."));
}

void WindowShell::openLogFolder() {
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(log_.folder()))) {
    window_.messages.showMessage(
        Tone::Caution,
        tr("No program to show folders was found. The log is %1.").arg(QDir::toNativeSeparators(log_.filePath())));
  }
}

}  // namespace hexoderm
