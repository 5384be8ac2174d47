#include "app/window/main_window/panels.h"

#include "app/window/guide/welcome_panel.h"
#include "app/window/log/log_view.h"
#include "app/window/main_window/views.h"
#include "app/window/toolkit/table_views.h"
#include "app/window/toolkit/view_swap.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/step_panel.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/plot/plot_view.h"
#include "widgets/robot/robot_view.h"
#include "widgets/verify/residual_view.h"

#include <QFrame>
#include <QGridLayout>
#include <QSettings>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableView>
#include <QVBoxLayout>

namespace hexoderm {
namespace {

/// Raised when docks come or go, so that an older layout is not forced onto a newer window.
constexpr int kLayoutVersion = 3;
const QString kState = QStringLiteral("window/state");

}  // namespace

Panels::Panels(const Views& views, QWidget* parent) : QMainWindow(parent) {
  setWindowFlags(Qt::Widget);
  setContextMenuPolicy(Qt::PreventContextMenu);
  setCentralWidget(makeCentre(views));
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  // So wide that the sentences of the steps can be read, whatever the size of the text.
  constexpr int kStepCharacters = 36;
  views.steps->setMinimumWidth(kStepCharacters * fontMetrics().averageCharWidth());
  // All columns of the poses, with their headings.
  constexpr int kPoseCharacters = 56;
  views.tables.pose_view->setMinimumWidth(kPoseCharacters * fontMetrics().averageCharWidth());
  steps_ = new CardDock(tr("Steps"), QStringLiteral("stepsDock"), views.steps, this);
  graph_ = new CardDock(tr("Skin graph"), QStringLiteral("graphDock"), views.graph, this);
  poses_ = new CardDock(tr("Poses"), QStringLiteral("poseDock"), makeTable(views.tables.pose_view, tr("No poses yet.")),
                        this);
  views.coverage->setEmptyHint(tr("No poses yet."));
  coverage_ = new CardDock(tr("Directions seen"), QStringLiteral("coverageDock"), views.coverage, this);
  plot_ = new CardDock(tr("Plot"), QStringLiteral("plotDock"), views.plot, this);
  swap_ = std::make_unique<ViewSwap>(*views.patch, *views.graph, *graph_);
  // In their order from below.
  connect(swap_.get(), &ViewSwap::swapped, views.robot, &QWidget::raise);
  connect(swap_.get(), &ViewSwap::swapped, views.welcome, &QWidget::raise);
  details_ = makeDetails(views);
  arrange();
}

Panels::~Panels() = default;

QWidget* Panels::makeCentre(const Views& views) {
  views.patch->setAccessibleName(tr("The patch in three dimensions"));
  views.patch->setMinimumSize(320, 240);
  middle_ = new QWidget;
  auto* place_layout = new QVBoxLayout(middle_);
  place_layout->setContentsMargins(0, 0, 0, 0);
  place_layout->addWidget(views.patch);
  // One above the other, so that the 3D view gets its graphics ready while nobody waits for it.
  auto* stack = new QWidget;
  auto* stack_layout = new QGridLayout(stack);
  stack_layout->setContentsMargins(0, 0, 0, 0);
  stack_layout->addWidget(middle_, 0, 0);
  stack_layout->addWidget(views.robot, 0, 0);
  views.robot->hide();
  stack_layout->addWidget(views.welcome, 0, 0);
  views.welcome->raise();
  auto* card = new QFrame;
  card->setProperty("card", true);
  auto* layout = new QVBoxLayout(card);
  layout->setContentsMargins(1, 1, 1, 1);
  layout->addWidget(stack);
  return card;
}

TableOrHint* Panels::makeTable(QTableView* view, const QString& hint) {
  tables_.push_back(new TableOrHint(view, hint));
  return tables_.back();
}

CardDock* Panels::makeDetails(const Views& views) {
  auto* pages = new QStackedWidget;
  QTabBar* tabs = views.detail_tabs;
  const auto add = [pages, tabs](QWidget* page, const QString& title) {
    pages->addWidget(page);
    tabs->addTab(title);
  };
  tabs->setObjectName(QStringLiteral("detailTabs"));
  tabs->setDrawBase(false);
  add(makeTable(views.tables.finding_view, tr("No findings.")), tr("Findings"));
  add(makeTable(views.tables.link_view, tr("No links yet.")), tr("Links"));
  add(makeTable(views.tables.cell_view, tr("No cells yet.")), tr("Cells"));
  add(views.residuals, tr("Residuals"));
  add(views.log, tr("Log"));
  add(views.stillness, tr("Stillness"));
  connect(tabs, &QTabBar::currentChanged, pages, &QStackedWidget::setCurrentIndex);
  auto* dock = new CardDock(tr("Findings and links"), QStringLiteral("detailsDock"), pages, this);
  dock->setHead(tabs);
  return dock;
}

void Panels::arrange() {
  addDockWidget(Qt::LeftDockWidgetArea, steps_);
  addDockWidget(Qt::RightDockWidgetArea, graph_);
  addDockWidget(Qt::RightDockWidgetArea, coverage_);
  addDockWidget(Qt::RightDockWidgetArea, poses_);
  addDockWidget(Qt::BottomDockWidgetArea, details_);
  tabifyDockWidget(coverage_, plot_);
  plot_->hide();
  resizeDocks({steps_, graph_}, {286, 420}, Qt::Horizontal);
  resizeDocks({graph_, coverage_, poses_}, {230, 258, 170}, Qt::Vertical);
  resizeDocks({details_}, {170}, Qt::Vertical);
}

std::vector<QAction*> Panels::toggleActions() const {
  return {steps_->toggleViewAction(), graph_->toggleViewAction(), coverage_->toggleViewAction(),
          poses_->toggleViewAction(), details_->toggleViewAction()};
}

void Panels::restore(const QSettings& settings) { restoreState(settings.value(kState).toByteArray(), kLayoutVersion); }

void Panels::remember(QSettings& settings) const { settings.setValue(kState, saveState(kLayoutVersion)); }

}  // namespace hexoderm
