#pragma once

#include "app/window/guide/guide.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/presenters/presenter.h"
#include "app/window/presenters/result_presenter.h"
#include "hexoderm/base/finding.h"
#include "hexoderm/solve/metrics/assess.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"
#include "widgets/tables/row_picking.h"
#include "widgets/tables/table_csv.h"

#include <QTableView>
#include <optional>

namespace hexoderm {

/// Keeps the same pose, link or cell picked in all the views that a result is reviewed in.
class ReviewPresenter : public Presenter {
  Q_OBJECT

 public:
  ReviewPresenter(const WindowParts& parts, FilePresenter& files, const ResultPresenter& results) : Presenter(parts) {
    const ResultTables& tables = views.tables;
    files.saveTablesOf(new CsvActions(tables.pose_view, QStringLiteral("poses")));
    files.saveTablesOf(new CsvActions(tables.link_view, QStringLiteral("links")));
    files.saveTablesOf(new CsvActions(tables.cell_view, QStringLiteral("cells")));
    files.saveTablesOf(new CsvActions(tables.finding_view, QStringLiteral("findings")));
    files.saveTablesOf(new CsvActions(views.residuals->matrix(), QStringLiteral("residuals")));
    connectTables();
    connect(&results, &ResultPresenter::handedOut, this, &ReviewPresenter::showPicks);
    connect(&controller, &SessionController::opened, this, [this] {
      selection.clear();
      picked_pose_.reset();
    });
    connect(&selection, &Selection::changed, this, &ReviewPresenter::showPickedLink);
    connect(&selection, &Selection::changed, this, &ReviewPresenter::showPickedCell);
    connect(&selection, &Selection::sought, this, &ReviewPresenter::scrollToPicked);
    connect(views.check_list, &CheckList::cellPicked, &selection, &Selection::seekCell);
    connect(views.residuals, &ResidualView::posePicked, this, &ReviewPresenter::pickPose);
    connect(views.coverage, &CoverageView::posePicked, this, &ReviewPresenter::pickPose);
    connectActions();
  }

  /// Its row among the poses of the result that is shown.
  [[nodiscard]] std::optional<int> pickedPoseRow() const {
    const QModelIndexList rows = views.tables.pose_view->selectionModel()->selectedRows();
    return rows.isEmpty() ? std::nullopt : std::optional(sourceRow(rows.front()));
  }

  void pickPose(PoseId pose) {
    const Reconstruction* shown = controller.reconstruction().get();
    QTableView* view = views.tables.pose_view;
    for (std::size_t row = 0; shown && row < shown->poses.size(); ++row) {
      if (shown->poses[row].pose == pose) view->selectRow(shownRow(view, static_cast<int>(row)).row());
    }
  }

  /// Picks what it is about, and lets the views turn to it.
  void showFinding(const Finding& finding) {
    if (!finding.poses.empty()) pickPose(finding.poses.front());
    if (finding.cells.size() >= 2 && finding.ports.size() >= 2) {
      selection.seekLink({finding.cells[0], finding.ports[0]}, {finding.cells[1], finding.ports[1]});
    } else if (!finding.cells.empty()) {
      selection.seekCell(finding.cells.front());
    }
  }

 signals:
  void pickedPoseChanged();

 private:
  void connectTables() {
    const ResultTables& tables = views.tables;
    const auto show = [this](const QModelIndex& index) { showFinding(views.tables.findings->findingAt(index.row())); };
    connect(tables.finding_view, &QTableView::clicked, this, show);
    onPicked(tables.finding_view, this, show);
    onPicked(tables.link_view, this, [this](const QModelIndex& picked) {
      const LinkEstimate& link = views.tables.links->linkAt(sourceRow(picked));
      selection.selectLink(link.source, link.target);
    });
    onPicked(tables.cell_view, this, [this](const QModelIndex& picked) {
      selection.selectCell(views.tables.cells->cellAt(sourceRow(picked)));
    });
    connect(tables.link_view, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
      const LinkEstimate& link = views.tables.links->linkAt(sourceRow(index));
      selection.seekLink(link.source, link.target);
    });
    connect(tables.cell_view, &QTableView::doubleClicked, this,
            [this](const QModelIndex& index) { selection.seekCell(views.tables.cells->cellAt(sourceRow(index))); });
    connect(tables.pose_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ReviewPresenter::showPickedPose);
    onPicked(tables.pose_view, this, [this](const QModelIndex& /*picked*/) { showPickedPose(); });
  }

  void showPicks() {
    PatchOverlays overlays = views.patch->overlays();
    overlays.truth = controller.session() ? controller.session()->truth() : nullptr;
    views.patch->setOverlays(overlays);
    // The pose stays picked although the tables start anew. Qt's selection models tell nobody when they are reset, so
    // that it is still known here.
    if (const std::optional<PoseId> picked = picked_pose_) pickPose(*picked);
    showPickedPose();
    showPickedLink();
    showPickedCell();
  }

  void showPickedPose() {
    picked_pose_.reset();
    if (const std::optional<int> row = pickedPoseRow()) {
      picked_pose_ = views.tables.poses->reconstruction()->poses[static_cast<std::size_t>(*row)].pose;
    }
    PatchMoment moment = views.patch->moment();
    moment.pose = picked_pose_;
    views.patch->setMoment(moment);
    views.coverage->setPickedPose(picked_pose_);
    emit pickedPoseChanged();
  }

  void showPickedLink() {
    const std::optional<Selection::Link> link = selection.link();
    selectSourceRow(views.tables.link_view, link ? views.tables.links->rowOf(link->first, link->second) : -1);
  }

  void showPickedCell() {
    const std::optional<CellId> cell = selection.cell();
    selectSourceRow(views.tables.cell_view, cell ? views.tables.cells->rowOf(*cell) : -1);
  }

  void connectActions() {
    connect(actions.show_finding, &QAction::triggered, this, &ReviewPresenter::showWorstFinding);
    connect(actions.worst_cell, &QAction::triggered, this, &ReviewPresenter::showWorstCell);
    connect(actions.figures, &QAction::triggered, this, [this] { showMetrics(!views.patch->areMetricsShown()); });
  }

  /// A row that is picked already may have been scrolled away.
  void scrollToPicked() {
    for (QTableView* view : {views.tables.cell_view, views.tables.link_view}) {
      const QModelIndexList rows = view->selectionModel()->selectedRows();
      if (!rows.isEmpty()) view->scrollTo(rows.front());
    }
  }

  void showWorstFinding() {
    const Finding* worst = controller.reconstruction() ? worstFinding(*controller.reconstruction()) : nullptr;
    if (!worst) return;
    views.steps->openStep(static_cast<int>(GuideStep::Review));
    for (int row = 0; row < views.tables.findings->rowCount(); ++row) {
      if (&views.tables.findings->findingAt(row) == worst) views.tables.finding_view->selectRow(row);
    }
    showFinding(*worst);
  }

  /// Where position and orientation are least certain at two cells, the second time shows the other one.
  void showWorstCell() {
    const Reconstruction* result = controller.reconstruction().get();
    const std::vector<CellId> worst = result ? worstCells(*result) : std::vector<CellId>();
    if (worst.empty()) return;
    selection.seekCell(selection.cell() == worst.front() ? worst.back() : worst.front());
    showMetrics(true);
    // So that the arrow keys go on to its neighbours.
    QWidget* const walkable = views.patch->isVisible() ? static_cast<QWidget*>(views.patch) : views.graph;
    walkable->setFocus(Qt::ShortcutFocusReason);
  }

  void showMetrics(bool shown) {
    views.patch->setMetricsShown(shown);
    // Where there is no 3D view, or another view in its place, the graph has them.
    const bool is_seen = views.patch->isVisible() && views.patch->areMetricsShown();
    if (shown && !is_seen) views.graph->showMetrics();
  }

  std::optional<PoseId> picked_pose_;
};

}  // namespace hexoderm
