#pragma once

#include "app/window/guide/guide.h"
#include "app/window/toolkit/table_views.h"
#include "app/window/views/views.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/view_mark.h"

#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QScrollArea>
#include <QSettings>
#include <QSize>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>
#include <vector>

namespace hexoderm {

/// Lays the views out: one in the middle, the others in panels around it that the operator can move. While the step
/// Verify is open, its checks lie beside the middle and have the room of all panels but the steps.
class Panels : public QMainWindow {
  Q_OBJECT

 public:
  /// Takes over the views that it shows; the list of them outlives the panels.
  explicit Panels(const Views& views, QWidget* parent = nullptr) : QMainWindow(parent), views_(views) {
    setObjectName(QStringLiteral("panels"));
    setWindowFlags(Qt::Widget);
    setContextMenuPolicy(Qt::PreventContextMenu);
    setCentralWidget(makeCentre(views));
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    views.steps->setMinimumWidth(kStepCharacters * fontMetrics().averageCharWidth());
    views.tables.pose_view->setMinimumWidth(kSideCharacters * fontMetrics().averageCharWidth());
    // Less than it asks for, where the text is large and the window low.
    constexpr int kLowGraph_px = 84;
    views.graph->setMinimumHeight(kLowGraph_px);
    steps_ = new CardDock(tr("Steps"), QStringLiteral("stepsDock"), views.steps, this);
    graph_ = new CardDock(tr("Skin graph"), QStringLiteral("graphDock"), views.graph, this);
    poses_ = new CardDock(tr("Poses"), QStringLiteral("poseDock"),
                          makeTable(views.tables.pose_view, tr("No poses yet.")), this);
    views.coverage->setEmptyHint(tr("No poses yet."));
    coverage_ = new CardDock(tr("Directions seen"), QStringLiteral("coverageDock"), views.coverage, this);
    plot_ = new CardDock(tr("Plot"), QStringLiteral("plotDock"), views.plot, this);
    details_ = makeDetails(views);
    middle_mark_ = named(new ViewMark(middle_), "middleMark");
    side_mark_ = named(new ViewMark(graph_->widget()), "sideMark");
    placeMarks();
    if (QSettings().value(kSwapped, false).toBool()) exchangeViews();
    connect(views.steps, &StepPanel::opened, this,
            [this](int step) { setVerifying(step == static_cast<int>(GuideStep::Verify)); });
    arrange();
  }

  [[nodiscard]] CardDock& steps() { return *steps_; }
  [[nodiscard]] CardDock& graph() { return *graph_; }
  [[nodiscard]] CardDock& coverage() { return *coverage_; }
  /// Closed until somebody asks for it.
  [[nodiscard]] CardDock& plot() { return *plot_; }
  [[nodiscard]] CardDock& poses() { return *poses_; }
  [[nodiscard]] CardDock& details() { return *details_; }
  /// What lies in the middle: the 3D view or the graph. The robot takes its place.
  [[nodiscard]] QWidget& middle() { return *middle_; }
  /// Over what lies in the middle, and over what lies in the graph's panel.
  [[nodiscard]] ViewMark& middleMark() { return *middle_mark_; }
  [[nodiscard]] ViewMark& sideMark() { return *side_mark_; }
  /// The checks of the step Verify, which scroll.
  [[nodiscard]] QWidget& checks() { return *checks_; }
  [[nodiscard]] const std::vector<TableOrHint*>& tables() const { return tables_; }

  /// One a panel but the plot, which has an action of its own: shows or hides it.
  [[nodiscard]] std::vector<QAction*> toggleActions() const {
    return {steps_->toggleViewAction(), graph_->toggleViewAction(), coverage_->toggleViewAction(),
            poses_->toggleViewAction(), details_->toggleViewAction()};
  }

  /// As the operator left them at the last start.
  void restore(const QSettings& settings) {
    shareRoom();
    restoreState(settings.value(kState).toByteArray(), kLayoutVersion);
  }

  void remember(QSettings& settings) {
    setVerifying(false);
    settings.setValue(kState, saveState(kLayoutVersion));
  }

  /// As they are at the first start, in a window of this size.
  void reset() {
    const bool was_verifying = is_verifying_;
    setVerifying(false);
    if (isSwapped()) swapViews();
    for (CardDock* dock : docks()) {
      dock->setFloating(false);
      removeDockWidget(dock);
    }
    arrange();
    for (CardDock* dock : docks()) dock->setVisible(dock != plot_);
    layout()->activate();
    shareRoom();
    setVerifying(was_verifying);
  }

  /// Exchanges the 3D view and the graph: one is in the middle, the other in the graph's panel. The settings remember
  /// it for the next start.
  void swapViews() {
    exchangeViews();
    QSettings().setValue(kSwapped, isSwapped());
  }

 private:
  /// A panel that gave its room to the checks.
  struct PutAway {
    CardDock* dock;
    QSize size;
    bool in_front;  ///< of the tabs in its place
  };

  /// The panels that give way come back as they were.
  void setVerifying(bool verifying) {
    if (std::exchange(is_verifying_, verifying) == verifying) return;
    if (verifying) {
      makeRoomForChecks();
    } else {
      giveRoomBack();
    }
    centre_->widget(1)->setVisible(verifying);
    // The greater part is theirs.
    if (verifying) centre_->setSizes({width() * 9 / 20, width() * 11 / 20});
  }

  void makeRoomForChecks() {
    before_checks_.clear();
    for (CardDock* dock : {graph_, coverage_, plot_, poses_, details_}) {
      if (dock->isFloating() || dock->isHidden()) continue;
      const bool in_front = tabifiedDockWidgets(dock).isEmpty() || !dock->visibleRegion().isEmpty();
      before_checks_.push_back({dock, dock->size(), in_front});
    }
    for (const PutAway& away : before_checks_) away.dock->hide();
  }

  /// Not by QMainWindow::restoreState(), which reaches for docks that are being dragged at the moment.
  void giveRoomBack() {
    QList<QDockWidget*> docks;
    QList<int> widths;
    QList<int> heights;
    for (const PutAway& away : before_checks_) {
      if (away.dock->isFloating()) continue;
      away.dock->show();
      if (!away.in_front) continue;  // a tab that covers it says how large it is
      docks << away.dock;
      widths << away.size.width();
      heights << away.size.height();
    }
    resizeDocks(docks, widths, Qt::Horizontal);
    resizeDocks(docks, heights, Qt::Vertical);
    for (QDockWidget* dock : docks) dock->raise();
    before_checks_.clear();
  }

  [[nodiscard]] QWidget* makeCentre(const Views& views) {
    views.patch->setAccessibleName(tr("The patch in three dimensions"));
    views.patch->setMinimumSize(280, 200);
    middle_ = new QWidget;
    auto* place_layout = spaced(new QVBoxLayout(middle_), {0, 0, 0, 0});
    place_layout->addWidget(views.patch);
    // One above the other, so that the 3D view gets its graphics ready while nobody waits for it.
    auto* stack = new QWidget;
    auto* stack_layout = spaced(new QGridLayout(stack), {0, 0, 0, 0});
    stack_layout->addWidget(middle_, 0, 0);
    stack_layout->addWidget(views.robot, 0, 0);
    views.robot->hide();
    stack_layout->addWidget(views.welcome, 0, 0);
    views.welcome->raise();
    auto* card = styledAs(new QFrame, "card");
    auto* layout = spaced(new QVBoxLayout(card), {1, 1, 1, 1});
    layout->addWidget(stack);
    auto* checks_card = styledAs(new QFrame, "card");
    checks_ = named(new QScrollArea, "checksArea");
    scrollPlainly(checks_);
    checks_->setWidget(views.verify_panel);
    auto* checks_layout = spaced(new QVBoxLayout(checks_card), {1, 1, 1, 1});
    checks_layout->addWidget(checks_);
    checks_card->hide();
    centre_ = new QSplitter;
    centre_->setChildrenCollapsible(false);
    centre_->setHandleWidth(8);
    addWidgets(centre_, {card, checks_card});
    // The checks have the greater part.
    centre_->setStretchFactor(0, 9);
    centre_->setStretchFactor(1, 11);
    return centre_;
  }

  /// The table, and beside it the card of the finding that is picked in it. The step Review has that card, too.
  [[nodiscard]] QWidget* makeFindings(const Views& views) {
    auto* room = named(new QScrollArea, "findingsCard");
    scrollPlainly(room);
    auto* content = new QWidget;
    auto* column = spaced(new QVBoxLayout(content), {0, 0, 8, 8});
    column->addWidget(views.finding_card);
    column->addStretch(1);
    room->setWidget(content);
    // Where there is no finding, nothing is seen of it.
    content->setAutoFillBackground(false);
    room->viewport()->setAutoFillBackground(false);
    return new TableAndCard(makeTable(views.tables.finding_view, tr("No findings.")), room);
  }

  [[nodiscard]] CardDock* makeDetails(const Views& views) {
    auto* pages = new QStackedWidget;
    // The widest page does not keep the column from getting narrower.
    pages->setMinimumWidth(kSideCharacters * fontMetrics().averageCharWidth());
    QTabBar* tabs = views.detail_tabs;
    const auto add = [pages, tabs](QWidget* page, const QString& title) {
      pages->addWidget(page);
      tabs->addTab(title);
    };
    tabs->setObjectName(QStringLiteral("detailTabs"));
    tabs->setDrawBase(false);
    add(makeFindings(views), tr("Findings"));
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

  [[nodiscard]] TableOrHint* makeTable(QTableView* view, const QString& hint) {
    tables_.push_back(new TableOrHint(view, hint));
    return tables_.back();
  }

  void arrange() {
    addDockWidget(Qt::LeftDockWidgetArea, steps_);
    addDockWidget(Qt::RightDockWidgetArea, graph_);
    addDockWidget(Qt::RightDockWidgetArea, coverage_);
    addDockWidget(Qt::RightDockWidgetArea, poses_);
    addDockWidget(Qt::BottomDockWidgetArea, details_);
    tabifyDockWidget(coverage_, plot_);
    plot_->hide();
    shareRoom();
  }

  /// Among the panels, so that the middle has the greatest part in a small window as in a large one.
  void shareRoom() {
    const int character = fontMetrics().averageCharWidth();
    const int steps = std::max(kStepCharacters * character + 16, width() / 5);
    const int side = std::max(kSideCharacters * character + 16, width() * 28 / 100);
    resizeDocks({steps_, graph_}, {steps, side}, Qt::Horizontal);
    // Eight poses with their headings, where the graph has room enough all the same.
    constexpr int kRows = 13;
    const int small = std::max(0, 700 - height()) / 2;
    const int poses =
        std::max(height() / 4, std::min(kRows * (fontMetrics().height() + 8), height() * 39 / 100 - small));
    const int coverage = height() * 31 / 100;
    resizeDocks({graph_, coverage_, poses_}, {height() - coverage - poses, coverage, poses}, Qt::Vertical);
    resizeDocks({details_}, {height() * 39 / 100}, Qt::Vertical);
  }

  [[nodiscard]] std::vector<CardDock*> docks() const { return {steps_, graph_, coverage_, plot_, poses_, details_}; }

  void exchangeViews() {
    QWidget* const of_patch = views_.patch->parentWidget();
    QWidget* const of_graph = views_.graph->parentWidget();
    of_patch->layout()->removeWidget(views_.patch);
    of_graph->layout()->removeWidget(views_.graph);
    of_patch->layout()->addWidget(views_.graph);
    of_graph->layout()->addWidget(views_.patch);
    views_.graph->show();
    views_.patch->show();
    graph_->setHeading(isSwapped() ? tr("Skin patch") : tr("Skin graph"));
    // In their order from below.
    views_.robot->raise();
    views_.welcome->raise();
    placeMarks();
  }

  void placeMarks() {
    // Below the buttons over the 3D view, and beside that over the graph.
    constexpr int kAroundText_px = 30;
    const int buttons = fontMetrics().height() + kAroundText_px;
    middle_mark_->setPlace(isSwapped() ? 0 : buttons, isSwapped());
    side_mark_->setPlace(isSwapped() ? buttons : 0, !isSwapped());
  }

  [[nodiscard]] bool isSwapped() const { return graph_->isAncestorOf(views_.patch); }

  const Views& views_;

  QWidget* middle_ = nullptr;
  QSplitter* centre_ = nullptr;
  QScrollArea* checks_ = nullptr;
  ViewMark* middle_mark_ = nullptr;
  ViewMark* side_mark_ = nullptr;
  bool is_verifying_ = false;
  std::vector<PutAway> before_checks_;
  CardDock* steps_;
  CardDock* graph_;
  CardDock* poses_;
  CardDock* coverage_;
  CardDock* plot_;
  CardDock* details_;
  std::vector<TableOrHint*> tables_;

  /// Raised when docks come or go, so that an older layout is not forced onto a newer window.
  static constexpr int kLayoutVersion = 3;
  static inline const QString kState = QStringLiteral("window/state");
  static inline const QString kSwapped = QStringLiteral("window/swapped");
  /// So wide that the sentences of the steps can be read, whatever the size of the text.
  static constexpr int kStepCharacters = 35;
  /// The graph, the directions and the poses with their most important columns.
  static constexpr int kSideCharacters = 32;

  /// A table with a card beside it, which is left out where it would leave the table too little room.
  class TableAndCard : public QWidget {
   public:
    explicit TableAndCard(QWidget* table, QWidget* card) : card_(card) {
      auto* row = spaced(new QHBoxLayout(this), {0, 0, 0, 0}, 8);
      constexpr int kTableShare = 3;
      constexpr int kCardShare = 2;
      row->addWidget(table, kTableShare);
      row->addWidget(card, kCardShare);
    }

   protected:
    void resizeEvent(QResizeEvent* event) override {
      constexpr int kMinCharacters = 64;
      card_->setVisible(width() >= kMinCharacters * fontMetrics().averageCharWidth());
      QWidget::resizeEvent(event);
    }

   private:
    QWidget* card_;
  };
};

}  // namespace hexoderm
