#include "app/window/main_window/main_window.h"

#include "app/window/files/earlier_panel.h"
#include "app/window/files/session_paths.h"
#include "app/window/guide/welcome_panel.h"
#include "app/window/log/event_recorder.h"
#include "app/window/log/log_view.h"
#include "app/window/main_window/panels.h"
#include "app/window/main_window/views.h"
#include "app/window/presenters/capture_presenter.h"
#include "app/window/presenters/coloring_presenter.h"
#include "app/window/presenters/compare_presenter.h"
#include "app/window/presenters/connection_presenter.h"
#include "app/window/presenters/export_presenter.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/presenters/finding_presenter.h"
#include "app/window/presenters/guide_presenter.h"
#include "app/window/presenters/help_presenter.h"
#include "app/window/presenters/history_presenter.h"
#include "app/window/presenters/keyboard.h"
#include "app/window/presenters/log_presenter.h"
#include "app/window/presenters/mark_presenter.h"
#include "app/window/presenters/picked_commands.h"
#include "app/window/presenters/picture_presenter.h"
#include "app/window/presenters/place_presenter.h"
#include "app/window/presenters/plot_presenter.h"
#include "app/window/presenters/preferences_presenter.h"
#include "app/window/presenters/result_presenter.h"
#include "app/window/presenters/review_presenter.h"
#include "app/window/presenters/speech_presenter.h"
#include "app/window/presenters/status_presenter.h"
#include "app/window/presenters/theme_presenter.h"
#include "app/window/presenters/verify_presenter.h"
#include "app/window/presenters/view_commands.h"
#include "app/window/session/placing.h"
#include "app/window/session/verification.h"
#include "app/window/toolkit/status_bar.h"
#include "app/window/toolkit/table_views.h"
#include "widgets/capture/capture_panel.h"
#include "widgets/capture/capture_tone.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/instruction_voice.h"
#include "widgets/capture/live_strip.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/check_list.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/finding_card.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/notice_stack.h"
#include "widgets/controls/step_panel.h"
#include "widgets/controls/view_mark.h"
#include "widgets/controls/work_notice.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/plot/plot_view.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_view.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"
#include "widgets/verify/residual_view.h"
#include "widgets/verify/verify_panel.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QTabBar>
#include <QTableView>
#include <QUrl>
#include <QVBoxLayout>

namespace hexoderm {
namespace {

const QString kGeometry = QStringLiteral("window/geometry");

/// The one local file of a drag, if that is what is dragged.
QString droppedFile(const QMimeData* data) {
  return data->urls().size() == 1 && data->urls().front().isLocalFile() ? data->urls().front().toLocalFile()
                                                                        : QString();
}

/// For a window with a title bar, whose height nobody knows before there is one.
QSize roomOnScreen(const QWidget& window) {
  const int title_px = window.fontMetrics().height() * 5 / 2;
  constexpr int kBorder_px = 2;
  return window.screen()->availableSize() - QSize(kBorder_px, title_px + kBorder_px);
}

}  // namespace

/// Each gets the views and the parts of the window that it needs, and those presenters before it that it asks.
struct MainWindow::Presenters {
  Presenters(MainWindow& window, const Views& views, Panels& panels)
      : recorder(window.log_, window.controller_, *views.messages, window.QWidget::actions()),
        results(window.controller_),
        themes(window.actions_, window.preferences_),
        files(window, window.controller_, window.actions_, *views.messages),
        pictures({window, *views.patch, *views.robot, *views.graph}, window.controller_, window.actions_, files,
                 window.refresh_),
        connection({window, *views.live_strip, *views.status, *views.messages}, window.controller_, window.actions_,
                   files, window.log_),
        capture({*views.steps, *views.capture_panel, *views.coverage, panels.coverage(), *views.stillness, *views.patch,
                 *views.tone},
                window.controller_, window.actions_, window.selection_, window.preferences_),
        review({*views.steps, *views.check_list, window.views_->tables, *views.residuals, *views.coverage, *views.patch,
                *views.graph},
               window.controller_, window.actions_, window.selection_, files, results),
        coloring({*views.steps, *views.patch, *views.graph}, window.controller_, results, window.preferences_,
                 window.scale_ranges_),
        picked({*views.steps, *views.graph, *views.tables.link_view, *views.messages}, window.controller_,
               window.actions_, window.selection_, review),
        findings({*views.steps, *views.check_findings, *views.review_findings, *views.finding_card,
                  *views.tables.findings, *views.tables.finding_view},
                 window.controller_, window.actions_, window.selection_, review),
        verify({window, *views.verify_panel, *views.patch}, window.controller_, verification, files),
        exports(window, window.controller_, verification, window.actions_, files),
        place({window, *views.steps, *views.place_panel, *views.robot, panels.middle()}, window.controller_, placing),
        compare(window, window.controller_, window.actions_, window.selection_, verification),
        plot({*views.plot, panels.plot(), *views.verify_panel}, window.controller_, window.actions_),
        marks({*views.work_notice, panels.middleMark(), panels.sideMark()}, window.controller_, window.actions_),
        guide({*views.banner, *views.steps, *views.check_list}, window.controller_, window.actions_),
        status({window, *views.session_name, *views.status, panels.graph(), panels.poses(), *views.detail_tabs},
               window.controller_),
        history({window, *views.welcome, *views.earlier, *views.messages}, {window.recent_, window.unsaved_},
                window.controller_, window.actions_, files, window.log_),
        preferences({window, *views.messages}, window.controller_, window.actions_, window.preferences_, themes),
        speech({*views.capture_panel, *views.voice}, window.controller_, window.actions_, window.preferences_,
               preferences),
        log({window, *views.log, *views.messages}, window.controller_, window.actions_, window.log_),
        help(window, *views.menus, window.controller_, window.actions_),
        view_commands(
            {*views.patch, *views.robot, *views.graph, panels.graph(), *views.steps, panels.steps(), panels.swap()},
            window.actions_),
        // As one reads the window: from the top, and from left to right.
        keyboard(
            {views.banner, views.messages, views.live_strip, views.work_notice, views.steps, panels.centralWidget(),
             &panels.graph(), &panels.coverage(), &panels.plot(), &panels.poses(), &panels.details()},
            window.actions_) {}

  EventRecorder recorder;
  ResultPresenter results;
  ThemePresenter themes;
  FilePresenter files;
  PicturePresenter pictures;
  ConnectionPresenter connection;
  CapturePresenter capture;
  ReviewPresenter review;
  ColoringPresenter coloring;
  PickedCommands picked;
  FindingPresenter findings;
  Verification verification;
  VerifyPresenter verify;
  ExportPresenter exports;
  Placing placing;
  PlacePresenter place;
  ComparePresenter compare;
  PlotPresenter plot;
  MarkPresenter marks;
  GuidePresenter guide;
  StatusPresenter status;
  HistoryPresenter history;
  PreferencesPresenter preferences;
  SpeechPresenter speech;
  LogPresenter log;
  HelpPresenter help;
  ViewCommands view_commands;
  Keyboard keyboard;
};

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      wheel_guard_(*QCoreApplication::instance()),
      actions_(this, controller_.undoStack()),
      log_(logFolder()),
      recent_(jobs_),
      unsaved_(jobs_, unsavedFolder()),
      refresh_([this] { refresh(); }) {
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  // At first no part has the focus, and none has it after a click beside all, so that keys mean what the list of keys
  // says. Tab does not stop here: nothing would be seen of it.
  setFocusPolicy(Qt::ClickFocus);
  setFocus();
  views_ = std::make_unique<Views>(Views::Sources{selection_, actions_, log_, recent_, unsaved_}, this);
  panels_ = new Panels(*views_, this);
  layOut();
  presenters_ = std::make_unique<Presenters>(*this, *views_, *panels_);
  handOutResults();
  connectRefresh();
  setThemeChoice(preferences_.theme(), false);
  restoreLayout();
  refresh();
  presenters_->history.search();
}

MainWindow::~MainWindow() {
  // The presenters wire the views to each other, and the views refer to members; left to QObject they would go after
  // them.
  presenters_.reset();
  delete takeCentralWidget();
}

void MainWindow::layOut() {
  auto* work = new QVBoxLayout;
  work->setContentsMargins(8, 8, 8, 8);
  work->setSpacing(8);
  work->addWidget(panels_, 1);
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(views_->banner);
  layout->addLayout(work, 1);
  setCentralWidget(centre);
  auto* notices = new NoticeStack(centre);
  notices->add(views_->work_notice);
  notices->add(views_->live_strip);
  notices->add(views_->messages);
  setMenuWidget(makeTopBar());
  setStatusBar(views_->status);
}

QWidget* MainWindow::makeTopBar() {
  auto* app_name = new QLabel(QStringLiteral("Hexoderm"));
  app_name->setObjectName(QStringLiteral("appName"));
  views_->session_name->setObjectName(QStringLiteral("sessionName"));
  views_->session_name->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  actions_.fillMenuBar(views_->menus, panels_->toggleActions());
  auto* top_bar = new QFrame;
  top_bar->setObjectName(QStringLiteral("topBar"));
  auto* layout = new QHBoxLayout(top_bar);
  layout->setContentsMargins(0, 0, 0, 1);  // the line below
  layout->setSpacing(0);
  layout->addWidget(app_name);
  layout->addWidget(views_->menus);
  layout->addWidget(views_->session_name, 1);
  return top_bar;
}

/// Every view that shows a result, in the one order in which they get it, and every one that says why it has none.
void MainWindow::handOutResults() {
  ResultPresenter& results = presenters_->results;
  results.add(views_->tables.poses);
  results.add(views_->tables.links);
  results.add(views_->tables.findings);
  results.add(views_->tables.cells);
  results.add(&presenters_->findings);
  results.addPicture(views_->graph);
  results.addPicture(views_->patch);
  results.add(views_->plot);
  results.add(views_->residuals);
  results.add(views_->verify_panel);
  results.add(&presenters_->verification);
  results.add(&presenters_->place);
  results.add(&presenters_->capture);
  results.addWaiting(views_->graph);
  results.addWaiting(views_->patch);
  results.addWaiting(views_->coverage);
  results.addWaiting(views_->verify_panel);
  for (TableOrHint* table : panels_->tables()) results.addWaiting(table);
}

void MainWindow::connectRefresh() {
  connect(&controller_, &SessionController::changed, &refresh_, &OncePerTurn::request);
  connect(&controller_.poseGuide(), &PoseGuide::nextPoseChanged, &refresh_, &OncePerTurn::request);
  connect(&presenters_->review, &ReviewPresenter::pickedPoseChanged, &refresh_, &OncePerTurn::request);
  connect(actions_.reset_layout, &QAction::triggered, panels_, &Panels::reset);
  connect(&refresh_, &OncePerTurn::done, this, &MainWindow::refreshed);
  connect(&presenters_->review, &ReviewPresenter::findingsWanted, this, [this] {
    panels_->details().show();
    panels_->details().raise();
    views_->detail_tabs->setCurrentIndex(0);
  });
}

void MainWindow::refresh() {
  presenters_->picked.refresh();  // the guide asks the actions
  presenters_->guide.refresh();
  presenters_->speech.refresh();
  presenters_->findings.refresh();
  presenters_->results.refresh();
  presenters_->marks.refresh();
  presenters_->place.refresh();
  presenters_->status.refresh();
  presenters_->connection.refresh();
  presenters_->history.refresh();
}

PlacePanel* MainWindow::placePanel() { return views_->place_panel; }
RobotView* MainWindow::robotView() { return views_->robot; }
VerifyPanel* MainWindow::verifyPanel() { return views_->verify_panel; }
void MainWindow::openFile(const QString& path) { presenters_->files.openFile(path); }
void MainWindow::startDemo() { presenters_->files.startDemo(); }
void MainWindow::connectTo(const ConnectRequest& request) { presenters_->connection.connectTo(request); }
void MainWindow::setThemeChoice(ThemeChoice choice, bool remember) { presenters_->themes.setChoice(choice, remember); }
Theme MainWindow::theme() const { return themeOf(QApplication::palette()); }
QImage MainWindow::picture() { return presenters_->pictures.picture(); }

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!presenters_->files.mayClose()) {
    event->ignore();
    return;
  }
  QSettings settings;
  settings.setValue(kGeometry, saveGeometry());
  panels_->remember(settings);
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedFile(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = droppedFile(event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  if (!presenters_->place.takeFile(path)) openFile(path);
}

bool MainWindow::focusNextPrevChild(bool next) {
  return (presenters_ && presenters_->keyboard.moveToControl(next)) || QMainWindow::focusNextPrevChild(next);
}

/// On a screen that is smaller than what the panels need, everything is reached by scrolling.
void MainWindow::scrollIfScreenIsSmall() {
  const QSize least = minimumSizeHint();
  const QSize room = roomOnScreen(*this);
  if (least.width() <= room.width() && least.height() <= room.height()) return;
  auto* area = new QScrollArea;
  area->setObjectName(QStringLiteral("workArea"));
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidgetResizable(true);
  delete centralWidget()->layout()->replaceWidget(panels_, area);
  area->setWidget(panels_);
}

void MainWindow::restoreLayout() {
  scrollIfScreenIsSmall();
  resize(QSize(1440, 900).boundedTo(roomOnScreen(*this)));
  const QSettings settings;
  restoreGeometry(settings.value(kGeometry).toByteArray());
  // So that the panels know how much room they have.
  layout()->activate();
  centralWidget()->layout()->activate();
  panels_->restore(settings);
}

}  // namespace hexoderm
