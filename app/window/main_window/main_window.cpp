#include "app/window/main_window/main_window.h"

#include "app/window/files/session_paths.h"
#include "app/window/log/event_recorder.h"
#include "app/window/presenters/capture_presenter.h"
#include "app/window/presenters/coloring_presenter.h"
#include "app/window/presenters/compare_presenter.h"
#include "app/window/presenters/connection_presenter.h"
#include "app/window/presenters/export_presenter.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/presenters/finding_presenter.h"
#include "app/window/presenters/mark_presenter.h"
#include "app/window/presenters/picked_commands.h"
#include "app/window/presenters/picture_presenter.h"
#include "app/window/presenters/place_presenter.h"
#include "app/window/presenters/presenters.h"
#include "app/window/presenters/result_presenter.h"
#include "app/window/presenters/review_presenter.h"
#include "app/window/presenters/theme_presenter.h"
#include "app/window/session/placing.h"
#include "app/window/session/verification.h"
#include "app/window/toolkit/focus_order.h"
#include "app/window/toolkit/table_views.h"
#include "hexoderm/sim/simulated_source.h"
#include "widgets/controls/notice_stack.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QMimeData>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
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

/// Each gets those before it that it speaks to. Where several answer to the same signal, they do so in this order.
struct MainWindow::Presenters {
  explicit Presenters(MainWindow& window)
      : parts{wires,
              window,
              *window.views_,
              *window.panels_,
              window.refresh_,
              window.controller_,
              window.actions_,
              window.selection_,
              window.scale_ranges_,
              window.preferences_,
              window.log_,
              window.recent_,
              window.unsaved_},
        recorder(window.log_, window.controller_, *parts.views.messages, window.QWidget::actions()) {
    connectVerify(parts, verification, files);
    connectGuide(parts);
    connectHistory(parts, files);
    connectPreferences(parts, themes);
    connectHelp(parts);
    connectViewCommands(parts);
    const WindowActions& keys = parts.actions;
    connect(keys.next_pane, &QAction::triggered, &keyboard, [this] { keyboard.moveToPane(true); });
    connect(keys.previous_pane, &QAction::triggered, &keyboard, [this] { keyboard.moveToPane(false); });
  }

  QObject wires;
  const WindowParts parts;
  EventRecorder recorder;
  ResultPresenter results{parts.controller};
  ThemePresenter themes{parts};
  FilePresenter files{parts};
  PicturePresenter pictures{parts, files};
  ConnectionPresenter connection{parts, files};
  CapturePresenter capture{parts, results};
  ReviewPresenter review{parts, files, results};
  ColoringPresenter coloring{parts, results};
  PickedCommands picked{parts, review};
  FindingPresenter findings{parts, results, review};
  Verification verification;
  ExportPresenter exports{parts, verification, files};
  Placing placing;
  PlacePresenter place{parts, placing};
  ComparePresenter compare{parts, verification};
  MarkPresenter marks{parts};
  // As one reads the window: from the top, and from left to right.
  FocusOrder keyboard{{parts.views.banner, parts.views.messages, parts.views.live_strip, parts.views.work_notice,
                       parts.views.steps, parts.panels.centralWidget(), &parts.panels.graph(), &parts.panels.coverage(),
                       &parts.panels.plot(), &parts.panels.poses(), &parts.panels.details()}};
};

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      wheel_guard_(*QCoreApplication::instance()),
      actions_(this, controller_.undoStack()),
      log_(logFolder()),
      recent_(jobs_),
      unsaved_(jobs_, unsavedFolder()),
      refresh_([this] { refresh(); }) {
  addSimulatedSources();
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  // At first no part has the focus, and none has it after a click beside all, so that keys mean what the list of keys
  // says. Tab does not stop here: nothing would be seen of it.
  setFocusPolicy(Qt::ClickFocus);
  setFocus();
  views_ = std::make_unique<Views>(Views::Sources{selection_, actions_, log_, recent_, unsaved_}, this);
  panels_ = new Panels(*views_, this);
  layOut();
  presenters_ = std::make_unique<Presenters>(*this);
  handOutResults();
  connectRefresh();
  setThemeChoice(preferences_.theme(), false);
  restoreLayout();
  refresh();
  recent_.check();
  unsaved_.search();
}

MainWindow::~MainWindow() {
  // The presenters wire the views to each other, and the views refer to members; left to QObject they would go after
  // them.
  presenters_.reset();
  delete takeCentralWidget();
}

void MainWindow::layOut() {
  auto* work = spaced(new QVBoxLayout, {8, 8, 8, 8}, 8);
  work->addWidget(panels_, 1);
  auto* centre = new QWidget;
  auto* layout = spaced(new QVBoxLayout(centre), {0, 0, 0, 0}, 0);
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
  auto* app_name = named(new QLabel(QStringLiteral("Hexoderm")), "appName");
  views_->session_name->setObjectName(QStringLiteral("sessionName"));
  views_->session_name->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  actions_.fillMenuBar(views_->menus, panels_->toggleActions());
  auto* top_bar = named(new QFrame, "topBar");
  auto* layout = spaced(new QHBoxLayout(top_bar), {0, 0, 0, 1}, 0);  // the line below
  addWidgets(layout, {app_name, views_->menus});
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
  results.addPicture(views_->graph);
  results.addPicture(views_->patch);
  results.add(views_->plot);
  results.add(views_->residuals);
  results.add(views_->verify_panel);
  results.add(&presenters_->verification);
  results.add(&presenters_->place);
  results.addWaiting(views_->graph);
  results.addWaiting(views_->patch);
  results.addWaiting(views_->coverage);
  results.addWaiting(views_->verify_panel);
  for (TableOrHint* table : panels_->tables()) results.addWaiting(table);
}

void MainWindow::connectRefresh() {
  connect(&controller_, &SessionController::changed, &refresh_, &CoalescedRefresh::request);
  connect(&controller_.liveSession(), &LiveSession::nextPoseChanged, &refresh_, &CoalescedRefresh::request);
  connect(&presenters_->review, &ReviewPresenter::pickedPoseChanged, &refresh_, &CoalescedRefresh::request);
  connect(actions_.reset_layout, &QAction::triggered, panels_, &Panels::reset);
  connect(&refresh_, &CoalescedRefresh::done, this, &MainWindow::refreshed);
}

void MainWindow::refresh() {
  // Which actions can be used, before what asks them: steps, what is said aloud, and offers beside findings.
  presenters_->picked.refresh();
  refreshGuide(presenters_->parts);
  presenters_->findings.refresh();
  // Of the others none asks what another has done.
  presenters_->results.refresh();
  presenters_->marks.refresh();
  presenters_->place.refresh();
  refreshStatus(presenters_->parts);
  presenters_->connection.refresh();
  refreshHistory(presenters_->parts);
}

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
  auto* area = named(new QScrollArea, "workArea");
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
