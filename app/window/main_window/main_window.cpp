#include "app/window/main_window/main_window.h"

#include "app/window/main_window/window_shell.h"
#include "app/window/session/verification.h"
#include "app/window/toolkit/table_views.h"
#include "hexoderm/reconstruction/advice/verdict.h"
#include "hexoderm/util/text.h"
#include "widgets/capture/capture_panel.h"
#include "widgets/capture/capture_tone.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/live_strip.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/check_list.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/step_panel.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/style/system_theme.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"
#include "widgets/tables/row_picking.h"
#include "widgets/tables/sorted_table.h"
#include "widgets/verify/residual_view.h"
#include "widgets/verify/verify_panel.h"
#include "widgets/words/core_words.h"
#include "widgets/words/formatting.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabBar>
#include <QTableView>
#include <QVBoxLayout>

namespace hexoderm {
namespace {

/// Raised when docks come or go, so that an older layout is not forced onto a newer window.
constexpr int kLayoutVersion = 2;

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      actions_(this, controller_.undoStack()),
      docks_(new QMainWindow(this)),
      banner_(new Banner),
      message_bar_(new MessageBar),
      live_strip_(new LiveStrip(actions_.disconnect_skin)),
      step_panel_(new StepPanel),
      check_list_(new CheckList),
      capture_panel_(new CapturePanel({actions_.automatic, actions_.capture, actions_.skip_pose, actions_.turn})),
      coverage_view_(new CoverageView),
      stillness_view_(new StillnessView),
      tone_(new CaptureTone(this)),
      patch_view_(new PatchView(&selection_)),
      graph_view_(new GraphView(&selection_)),
      pose_table_(new PoseTable(this)),
      link_table_(new LinkTable(this)),
      finding_table_(new FindingTable(this)),
      cell_table_(new CellTable(this)),
      pose_view_(makeTable(new SortedTable(pose_table_, this), "poseView", tr("Poses"))),
      link_view_(makeTable(new SortedTable(link_table_, this), "linkView", tr("Links"))),
      finding_view_(makeTable(finding_table_, "findingView", tr("Findings"))),
      cell_view_(makeTable(new SortedTable(cell_table_, this), "cellView", tr("Cells"))),
      residual_view_(new ResidualView(&selection_)),
      verify_panel_(new VerifyPanel(&selection_, docks_)),
      verification_(new Verification(this)),
      detail_tabs_(new QTabBar),
      session_name_(new QLabel),
      source_status_(new QLabel),
      losses_status_(new QLabel),
      cells_status_(new QLabel),
      solve_status_(new QLabel),
      saved_status_(new QLabel),
      said_status_(new QLabel) {
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  // At first no part has the focus, and none has it after a click beside all, so that keys mean what the list of keys
  // says. Tab does not stop here: nothing would be seen of it.
  setFocusPolicy(Qt::ClickFocus);
  setFocus();
  buildShell();
  buildLayout();
  buildStatusBar();
  connectActions();
  connectController();
  connectSelection();
  connectLive();
  connectVerify();
  connectCapture();
  connectKeys();
  setThemeChoice(shell_->preferences().theme(), false);
  restoreLayout();
  shell_->begin(*findChild<QMenuBar*>());
  refresh();
}

MainWindow::~MainWindow() {
  qApp->removeEventFilter(this);
  // Views outlive this part of the window and must not hear from it any more.
  disconnect(&controller_, nullptr, this, nullptr);
  disconnect(&selection_, nullptr, this, nullptr);
  // The views refer to the selection, a member; left to QObject they would go after it.
  delete takeCentralWidget();
}

void MainWindow::buildLayout() {
  step_panel_->setBody(static_cast<int>(GuideStep::Connect), shell_->makeConnectBody());
  step_panel_->setBody(static_cast<int>(GuideStep::Check), check_list_);
  auto* card = new QFrame;
  card->setProperty("card", true);
  auto* card_layout = new QVBoxLayout(card);
  card_layout->setContentsMargins(1, 1, 1, 1);
  card_layout->addWidget(shell_->makeCentre(patch_view_));
  patch_view_->setAccessibleName(tr("The patch in three dimensions"));
  patch_view_->setMinimumSize(320, 240);

  stretchColumn(pose_view_, 1);
  stretchColumn(link_view_, link_table_->columnCount() - 1);
  stretchColumn(finding_view_, 1);
  stretchColumn(cell_view_, cell_table_->columnCount() - 1);
  wrapRows(finding_view_);
  wrapRows(pose_view_);

  docks_->setWindowFlags(Qt::Widget);
  docks_->setContextMenuPolicy(Qt::PreventContextMenu);
  docks_->setCentralWidget(card);
  docks_->setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  docks_->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  docks_->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  // So wide that the sentences of the steps can be read, whatever the size of the text.
  constexpr int kStepCharacters = 36;
  step_panel_->setMinimumWidth(kStepCharacters * fontMetrics().averageCharWidth());
  // All columns of the poses, with their headings.
  constexpr int kPoseCharacters = 56;
  pose_view_->setMinimumWidth(kPoseCharacters * fontMetrics().averageCharWidth());
  auto* steps = new CardDock(tr("Steps"), QStringLiteral("stepsDock"), step_panel_, docks_);
  for (std::size_t k = 0; k < actions_.go_to_step.size(); ++k) {
    connect(actions_.go_to_step[k], &QAction::triggered, this, [this, steps, k] {
      steps->show();
      steps->raise();
      step_panel_->goToStep(static_cast<int>(k));
    });
  }
  graph_dock_ = new CardDock(tr("Skin graph"), QStringLiteral("graphDock"), graph_view_, docks_);
  pose_dock_ = new CardDock(tr("Poses"), QStringLiteral("poseDock"), withHint(pose_view_, tr("No poses yet.")), docks_);
  coverage_view_->setEmptyHint(tr("No poses yet."));
  coverage_dock_ = new CardDock(tr("Directions seen"), QStringLiteral("coverageDock"), coverage_view_, docks_);
  shell_->setSwapped(patch_view_, graph_view_, graph_dock_);
  CardDock* details = buildDetails();
  docks_->addDockWidget(Qt::LeftDockWidgetArea, steps);
  docks_->addDockWidget(Qt::RightDockWidgetArea, graph_dock_);
  docks_->addDockWidget(Qt::RightDockWidgetArea, coverage_dock_);
  docks_->addDockWidget(Qt::RightDockWidgetArea, pose_dock_);
  docks_->addDockWidget(Qt::BottomDockWidgetArea, details);
  docks_->resizeDocks({steps, graph_dock_}, {286, 420}, Qt::Horizontal);
  docks_->resizeDocks({graph_dock_, coverage_dock_, pose_dock_}, {230, 258, 170}, Qt::Vertical);
  docks_->resizeDocks({details}, {170}, Qt::Vertical);

  auto* work = new QVBoxLayout;
  work->setContentsMargins(8, 8, 8, 8);
  work->setSpacing(8);
  work->addWidget(message_bar_);
  work->addWidget(live_strip_);
  work->addWidget(docks_, 1);
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(banner_);
  layout->addLayout(work, 1);
  setCentralWidget(centre);
  setMenuWidget(
      buildTopBar({steps->toggleViewAction(), graph_dock_->toggleViewAction(), coverage_dock_->toggleViewAction(),
                   pose_dock_->toggleViewAction(), details->toggleViewAction()}));
}

QWidget* MainWindow::buildTopBar(const std::vector<QAction*>& panels) {
  auto* app_name = new QLabel(QStringLiteral("Hexoderm"));
  app_name->setObjectName(QStringLiteral("appName"));
  session_name_->setObjectName(QStringLiteral("sessionName"));
  session_name_->setTextFormat(Qt::PlainText);
  auto* menu_bar = new QMenuBar;
  actions_.fillMenuBar(menu_bar, panels);
  auto* top_bar = new QFrame;
  top_bar->setObjectName(QStringLiteral("topBar"));
  auto* layout = new QHBoxLayout(top_bar);
  layout->setContentsMargins(0, 0, 0, 1);  // the line below
  layout->setSpacing(0);
  layout->addWidget(app_name);
  layout->addWidget(menu_bar, 1);
  layout->addWidget(session_name_);
  return top_bar;
}

CardDock* MainWindow::buildDetails() {
  auto* pages = new QStackedWidget;
  pages->addWidget(withHint(finding_view_, tr("No findings.")));
  pages->addWidget(withHint(link_view_, tr("No links yet.")));
  pages->addWidget(withHint(cell_view_, tr("No cells yet.")));
  pages->addWidget(residual_view_);
  pages->addWidget(shell_->makeLogView());
  pages->addWidget(stillness_view_);
  detail_tabs_->setObjectName(QStringLiteral("detailTabs"));
  detail_tabs_->setDrawBase(false);
  detail_tabs_->addTab(tr("Findings"));
  detail_tabs_->addTab(tr("Links"));
  detail_tabs_->addTab(tr("Cells"));
  detail_tabs_->addTab(tr("Residuals"));
  detail_tabs_->addTab(tr("Log"));
  detail_tabs_->addTab(tr("Stillness"));
  connect(detail_tabs_, &QTabBar::currentChanged, pages, &QStackedWidget::setCurrentIndex);
  auto* dock = new CardDock(tr("Findings and links"), QStringLiteral("detailsDock"), pages, docks_);
  dock->setHead(detail_tabs_);
  return dock;
}

void MainWindow::buildStatusBar() {
  for (QLabel* label : {source_status_, losses_status_, cells_status_, solve_status_, saved_status_, said_status_}) {
    label->setTextFormat(Qt::PlainText);
  }
  source_status_->setObjectName(QStringLiteral("sourceStatus"));
  losses_status_->setObjectName(QStringLiteral("lossesStatus"));
  losses_status_->hide();
  cells_status_->setObjectName(QStringLiteral("cellsStatus"));
  solve_status_->setObjectName(QStringLiteral("solveStatus"));
  saved_status_->setObjectName(QStringLiteral("savedStatus"));
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(source_status_);
  statusBar()->addWidget(losses_status_);
  statusBar()->addWidget(cells_status_);
  statusBar()->addWidget(solve_status_);
  said_status_->setObjectName(QStringLiteral("saidStatus"));
  said_status_->hide();
  statusBar()->addPermanentWidget(said_status_);
  statusBar()->addPermanentWidget(saved_status_);
  said_timer_.setSingleShot(true);
  connect(&said_timer_, &QTimer::timeout, said_status_, &QWidget::hide);
}

void MainWindow::connectActions() {
  connect(actions_.demo, &QAction::triggered, this, &MainWindow::startDemo);
  connect(actions_.open, &QAction::triggered, this, &MainWindow::askToOpen);
  connect(actions_.save, &QAction::triggered, this, [this] { saveSession(false); });
  connect(actions_.save_as, &QAction::triggered, this, [this] { saveSession(true); });
  connect(actions_.save_calibration, &QAction::triggered, this, &MainWindow::saveCalibration);
  connect(actions_.export_to, &QAction::triggered, this, &MainWindow::showExportDialog);
  connect(actions_.report, &QAction::triggered, this, &MainWindow::askForReport);
  connect(actions_.quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_.toggle_pose, &QAction::triggered, this, [this] {
    const std::optional<int> row = pickedPoseRow();
    const std::optional<std::size_t> index = row ? controller_.sessionIndexOfPoseRow(*row) : std::nullopt;
    if (index) controller_.setPoseDisabled(*index, !controller_.session()->poses()[*index].disabled);
  });
  connect(actions_.delete_pose, &QAction::triggered, this, [this] {
    const std::optional<int> row = pickedPoseRow();
    if (const auto index = row ? controller_.sessionIndexOfPoseRow(*row) : std::nullopt) controller_.removePose(*index);
  });
  connect(actions_.show_finding, &QAction::triggered, this, &MainWindow::showWorstFinding);
  connect(actions_.mute_link, &QAction::triggered, this, [this] {
    const auto link = selection_.link();
    if (!link || !controller_.session()) return;
    controller_.setLinkMuted(link->first, link->second,
                             !controller_.session()->findMutedLink(link->first, link->second));
  });
  graph_view_->setLinkActions({actions_.mute_link});
  graph_view_->setCellActions({actions_.light_cell});
  link_view_->setContextMenuPolicy(Qt::ActionsContextMenu);
  link_view_->addAction(actions_.mute_link);
  connect(graph_view_, &GraphView::pictureWanted, this, &MainWindow::saveGraph);
  connect(actions_.find_cell, &QAction::triggered, this, [this] {
    graph_dock_->show();
    graph_dock_->raise();
    graph_view_->findCell();
  });
  connect(actions_.fit, &QAction::triggered, graph_view_, &GraphView::fit);
  connect(actions_.fit, &QAction::triggered, patch_view_, &PatchView::fit);
  const auto look = [this](QAction* action, PatchView::StandardView view) {
    connect(action, &QAction::triggered, patch_view_, [this, view] { patch_view_->showStandardView(view); });
  };
  look(actions_.front, PatchView::StandardView::Front);
  look(actions_.side, PatchView::StandardView::Side);
  look(actions_.top, PatchView::StandardView::Top);
  connect(actions_.screenshot, &QAction::triggered, this, &MainWindow::savePicture);
  connect(actions_.guide, &QAction::triggered, this, &MainWindow::showGuide);
  connect(actions_.about, &QAction::triggered, this, &MainWindow::showAbout);
  connect(actions_.themes, &QActionGroup::triggered, this, [this](QAction* action) {
    setThemeChoice(static_cast<ThemeChoice>(actions_.themes->actions().indexOf(action)), true);
  });
  connect(new SystemThemeWatch(this), &SystemThemeWatch::changed, this, [this](Theme theme) {
    setSystemTheme(theme);
    if (actions_.theme[static_cast<std::size_t>(ThemeChoice::System)]->isChecked()) {
      setThemeChoice(ThemeChoice::System, false);
    }
  });
}

void MainWindow::connectController() {
  connect(&controller_, &SessionController::changed, this, &MainWindow::refresh);
  connect(
      &controller_, &SessionController::changed, this,
      [this] {
        if (close_when_written_ && !controller_.file().isWriting()) close();
      },
      Qt::QueuedConnection);
  connect(&controller_, &SessionController::reconstructionChanged, this, &MainWindow::showReconstruction);
  connect(&controller_, &SessionController::opened, this, [this] {
    message_bar_->hide();
    selection_.clear();
    picked_pose_.reset();
    openStep(controller_.liveSession().source().isRunning()
                 ? GuideStep::Capture
                 : (controller_.session() ? GuideStep::Review : GuideStep::Export));
  });
  connect(&controller_.file(), &SessionFile::sessionSaved, this, [this](const QString& path) {
    showDone(tr("Saved to %1").arg(path), path);
    if (const auto proceed = std::exchange(after_saving_, nullptr)) proceed();
  });
  connect(&controller_.resultFiles(), &ResultFiles::exported, this,
          [this](const QString& path) { showDone(tr("Exported to %1").arg(path), path); });
  connect(&controller_, &SessionController::failed, this, [this](const QString& message) {
    after_saving_ = nullptr;
    may_close_ = close_when_written_ = false;
    message_bar_->showMessage(Tone::Bad, message);
  });
}

void MainWindow::connectSelection() {
  connect(check_list_, &CheckList::cellPicked, &selection_, &Selection::selectCell);
  connect(&selection_, &Selection::changed, this, &MainWindow::showPickedLink);
  connect(&selection_, &Selection::changed, this, [this] {
    // The light on the skin follows what is picked here.
    if (controller_.liveSession().litCell() && selection_.cell())
      controller_.liveSession().lightCell(selection_.cell());
    actions_.refresh(controller_, pickedPoseRow(), selection_.cell());
    actions_.refreshLink(controller_, selection_.link());
  });
  connect(finding_view_, &QTableView::clicked, this,
          [this](const QModelIndex& index) { pickFromFinding(index.row()); });
  onPicked(finding_view_, this, [this](const QModelIndex& picked) { pickFromFinding(picked.row()); });
  onPicked(link_view_, this, [this](const QModelIndex& picked) {
    const LinkEstimate& link = link_table_->linkAt(sourceRow(picked));
    selection_.selectLink(link.source, link.target);
  });
  connect(pose_view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &MainWindow::showPickedPose);
  onPicked(pose_view_, this, [this](const QModelIndex& /*picked*/) { showPickedPose(); });
}

void MainWindow::showReconstruction(const std::shared_ptr<const Reconstruction>& reconstruction) {
  // The pose stays picked although the tables start anew.
  const std::optional<PoseId> picked = picked_pose_;
  pose_table_->setReconstruction(reconstruction);
  link_table_->setReconstruction(reconstruction);
  finding_table_->setReconstruction(reconstruction);
  // In live mode the pictures show the moment instead.
  if (!controller_.liveMode().isOn()) {
    graph_view_->setReconstruction(reconstruction);
    patch_view_->setReconstruction(reconstruction);
  }
  PatchOverlays overlays = patch_view_->overlays();
  overlays.truth = controller_.session() ? controller_.session()->truth() : nullptr;
  patch_view_->setOverlays(overlays);
  showReview(reconstruction);
  if (reconstruction && picked) pickPose(*picked);
  showPickedPose();
  showPickedLink();
}

void MainWindow::showPickedPose() {
  picked_pose_.reset();
  if (const std::optional<int> row = pickedPoseRow()) {
    picked_pose_ = pose_table_->reconstruction()->poses[static_cast<std::size_t>(*row)].pose;
  }
  PatchMoment moment = patch_view_->moment();
  moment.pose = picked_pose_;
  patch_view_->setMoment(moment);
  coverage_view_->setPickedPose(picked_pose_);
  refresh();
}

std::optional<int> MainWindow::pickedPoseRow() const {
  const QModelIndexList rows = pose_view_->selectionModel()->selectedRows();
  return rows.isEmpty() ? std::nullopt : std::optional(sourceRow(rows.front()));
}

void MainWindow::showPickedLink() {
  const int row = selection_.link() ? link_table_->rowOf(selection_.link()->first, selection_.link()->second) : -1;
  if (row < 0) {
    link_view_->clearSelection();
    link_view_->selectionModel()->clearCurrentIndex();
  } else if (const QModelIndex shown = shownRow(link_view_, row);
             !link_view_->selectionModel()->isRowSelected(shown.row(), {})) {
    link_view_->selectRow(shown.row());
  }
}

void MainWindow::pickFromFinding(int row) {
  const Finding& finding = finding_table_->findingAt(row);
  if (finding.cells.size() >= 2 && finding.ports.size() >= 2) {
    selection_.selectLink({finding.cells[0], finding.ports[0]}, {finding.cells[1], finding.ports[1]});
  } else if (!finding.cells.empty()) {
    selection_.selectCell(finding.cells.front());
  }
}

void MainWindow::showWorstFinding() {
  const Finding* worst = controller_.reconstruction() ? worstFinding(*controller_.reconstruction()) : nullptr;
  if (!worst) return;
  openStep(GuideStep::Review);
  for (int row = 0; row < finding_table_->rowCount(); ++row) {
    if (&finding_table_->findingAt(row) == worst) finding_view_->selectRow(row);
  }
}

void MainWindow::openStep(GuideStep step) { step_panel_->openStep(static_cast<int>(step)); }

void MainWindow::refresh() {
  actions_.refresh(controller_, pickedPoseRow(), selection_.cell());
  actions_.refreshLink(controller_, selection_.link());
  banner_->setContent(describeStand(controller_, actions_));
  const std::shared_ptr<const Reconstruction>& result = controller_.reconstruction();
  const LiveSource& live = controller_.liveSession().source();
  const SkinCheck check =
      result ? checkSkin(*result, live.preview().means, live.hold().stillness.odd_cells) : SkinCheck{};
  check_list_->setCheck(check);
  const std::vector<Step> steps = describeSteps(controller_, actions_, check);
  step_panel_->setSteps(steps);
  shell_->setSteps(steps);
  refreshStatus();
  refreshLive();
}

void MainWindow::refreshStatus() {
  const Reconstruction* result = controller_.reconstruction().get();
  const QString name = controller_.isEmpty() ? tr("No skin") : controller_.file().name();
  session_name_->setText(controller_.isEmpty() ? QString() : name);
  setWindowTitle(controller_.isEmpty() ? tr("Hexoderm") : tr("%1[*] · Hexoderm").arg(name));
  setWindowModified(controller_.file().hasUnsavedChanges());

  if (!controller_.liveSession().source().isRunning()) {
    source_status_->setText(QStringLiteral("● ") +
                            (controller_.work().activity().isEmpty() ? name : controller_.work().activity() + "…"));
  }
  cells_status_->setVisible(result != nullptr && !result->poses.empty());
  solve_status_->setVisible(result != nullptr);
  if (result) {
    std::size_t measured = 0;
    for (const PoseSummary& pose : result->poses) {
      if (pose.enabled) measured = std::max(measured, pose.cells_measured);
    }
    cells_status_->setText(tr("cells %1/%2").arg(measured).arg(result->cellCount()));
    cells_status_->setToolTip(tr("Cells that were measured in the fullest pose, of all cells"));
    solve_status_->setText(
        controller_.session()
            ? tr("solved in %1 ms · %2")
                  .arg(figureInWords(1e3 * result->solve_seconds, 1), QString::fromStdString(result->solver))
            : tr("%1, read from the file").arg(QString::fromStdString(result->solver)));
    solve_status_->setToolTip(tr("A direction counts as defined from a singular value of %1 on")
                                  .arg(figureInWords(result->options.class_threshold, 2)));
  }
  QString saved;
  if (controller_.file().hasUnsavedChanges()) {
    saved = controller_.file().isKept() ? tr("not on disk") : tr("not saved");
  } else if (controller_.file().savedAt().isValid()) {
    saved = tr("saved at %1").arg(controller_.file().savedAt().toString(QStringLiteral("HH:mm")));
  }
  saved_status_->setText(saved);

  graph_dock_->setRemark(result ? coreWords(sizeInWords(*result)) : QString());
  const bool has_poses = controller_.session() && !controller_.session()->poses().empty();
  const QString keys = controller_.liveSession().isLive() ? tr("R recapture · Del disable · Ctrl+Z undo")
                                                          : tr("Del disable · Ctrl+Z undo");
  pose_dock_->setRemark(has_poses ? keys : QString());
  detail_tabs_->setTabText(0, result ? tr("Findings %1").arg(result->findings.size()) : tr("Findings"));
  detail_tabs_->setTabText(1, result ? tr("Links %1").arg(result->linkCount()) : tr("Links"));
  detail_tabs_->setTabText(2, result ? tr("Cells %1").arg(result->cellCount()) : tr("Cells"));
}

void MainWindow::setThemeChoice(ThemeChoice choice, bool remember) {
  theme_ = resolveTheme(choice);
  applyTheme(theme_);
  banner_->setTheme(theme_);
  message_bar_->setTheme(theme_);
  live_strip_->setTheme(theme_);
  step_panel_->setTheme(theme_);
  check_list_->setTheme(theme_);
  capture_panel_->setTheme(theme_);
  coverage_view_->setTheme(theme_);
  stillness_view_->setTheme(theme_);
  patch_view_->setTheme(theme_);
  graph_view_->setTheme(theme_);
  residual_view_->setTheme(theme_);
  verify_panel_->setTheme(theme_);
  actions_.theme[static_cast<std::size_t>(choice)]->setChecked(true);
  if (remember) shell_->preferences().setTheme(choice);
}

/// On a screen that is smaller than what the panels need, everything is reached by scrolling.
void MainWindow::scrollIfScreenIsSmall() {
  // Messages and the strip of a live skin come and go, and panels need a little more when they are filled.
  constexpr double kReserve = 1.1;
  const QSize least =
      kReserve * minimumSizeHint() + QSize(0, message_bar_->sizeHint().height() + live_strip_->sizeHint().height());
  const QSize room = screen()->availableSize();
  if (least.width() <= room.width() && least.height() <= room.height()) return;
  auto* area = new QScrollArea;
  area->setObjectName(QStringLiteral("workArea"));
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidgetResizable(true);
  delete centralWidget()->layout()->replaceWidget(docks_, area);
  area->setWidget(docks_);
}

void MainWindow::restoreLayout() {
  scrollIfScreenIsSmall();
  resize(QSize(1440, 900).boundedTo(screen()->availableSize()));
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  docks_->restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), kLayoutVersion);
}

void MainWindow::rememberLayout() const {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  settings.setValue(QStringLiteral("window/state"), docks_->saveState(kLayoutVersion));
}

}  // namespace hexoderm
