#include "app/window/presenters/review_presenter.h"

#include "app/window/guide/guide.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/presenters/result_presenter.h"
#include "hexoderm/reconstruction/advice/assess.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"
#include "widgets/tables/row_picking.h"
#include "widgets/tables/table_csv.h"

#include <QTableView>

namespace hexoderm {

ReviewPresenter::ReviewPresenter(const WindowParts& parts, FilePresenter& files, const ResultPresenter& results)
    : Presenter(parts) {
  const ResultTables& tables = views_.tables;
  files.saveTablesOf(new CsvActions(tables.pose_view, QStringLiteral("poses")));
  files.saveTablesOf(new CsvActions(tables.link_view, QStringLiteral("links")));
  files.saveTablesOf(new CsvActions(tables.cell_view, QStringLiteral("cells")));
  files.saveTablesOf(new CsvActions(tables.finding_view, QStringLiteral("findings")));
  files.saveTablesOf(new CsvActions(views_.residuals->matrix(), QStringLiteral("residuals")));
  connectTables();
  connect(&results, &ResultPresenter::handedOut, this, &ReviewPresenter::showPicks);
  connect(&controller_, &SessionController::opened, this, [this] {
    selection_.clear();
    picked_pose_.reset();
  });
  connect(&selection_, &Selection::changed, this, &ReviewPresenter::showPickedLink);
  connect(&selection_, &Selection::changed, this, &ReviewPresenter::showPickedCell);
  connect(&selection_, &Selection::sought, this, &ReviewPresenter::scrollToPicked);
  connect(views_.check_list, &CheckList::cellPicked, &selection_, &Selection::seekCell);
  connect(views_.residuals, &ResidualView::posePicked, this, &ReviewPresenter::pickPose);
  connect(views_.coverage, &CoverageView::posePicked, this, &ReviewPresenter::pickPose);
  connectActions();
}

void ReviewPresenter::connectActions() {
  connect(actions_.show_finding, &QAction::triggered, this, &ReviewPresenter::showWorstFinding);
  connect(actions_.worst_cell, &QAction::triggered, this, &ReviewPresenter::showWorstCell);
  connect(actions_.figures, &QAction::triggered, this, [this] { showFigures(!views_.patch->areFiguresShown()); });
}

void ReviewPresenter::connectTables() {
  const ResultTables& tables = views_.tables;
  const auto show = [this](const QModelIndex& index) { showFinding(views_.tables.findings->findingAt(index.row())); };
  connect(tables.finding_view, &QTableView::clicked, this, show);
  onPicked(tables.finding_view, this, show);
  onPicked(tables.link_view, this, [this](const QModelIndex& picked) {
    const LinkEstimate& link = views_.tables.links->linkAt(sourceRow(picked));
    selection_.selectLink(link.source, link.target);
  });
  onPicked(tables.cell_view, this, [this](const QModelIndex& picked) {
    selection_.selectCell(views_.tables.cells->cellAt(sourceRow(picked)));
  });
  connect(tables.link_view, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    const LinkEstimate& link = views_.tables.links->linkAt(sourceRow(index));
    selection_.seekLink(link.source, link.target);
  });
  connect(tables.cell_view, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { selection_.seekCell(views_.tables.cells->cellAt(sourceRow(index))); });
  connect(tables.pose_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ReviewPresenter::showPickedPose);
  onPicked(tables.pose_view, this, [this](const QModelIndex& /*picked*/) { showPickedPose(); });
}

void ReviewPresenter::showPicks() {
  PatchOverlays overlays = views_.patch->overlays();
  overlays.truth = controller_.session() ? controller_.session()->truth() : nullptr;
  views_.patch->setOverlays(overlays);
  // The pose stays picked although the tables start anew. Qt's selection models tell nobody when they are reset, so
  // that it is still known here.
  if (const std::optional<PoseId> picked = picked_pose_) pickPose(*picked);
  showPickedPose();
  showPickedLink();
  showPickedCell();
}

void ReviewPresenter::showPickedPose() {
  picked_pose_.reset();
  if (const std::optional<int> row = pickedPoseRow()) {
    picked_pose_ = views_.tables.poses->reconstruction()->poses[static_cast<std::size_t>(*row)].pose;
  }
  PatchMoment moment = views_.patch->moment();
  moment.pose = picked_pose_;
  views_.patch->setMoment(moment);
  views_.coverage->setPickedPose(picked_pose_);
  emit pickedPoseChanged();
}

std::optional<int> ReviewPresenter::pickedPoseRow() const {
  const QModelIndexList rows = views_.tables.pose_view->selectionModel()->selectedRows();
  return rows.isEmpty() ? std::nullopt : std::optional(sourceRow(rows.front()));
}

void ReviewPresenter::showPickedLink() {
  const std::optional<Selection::Link> link = selection_.link();
  selectSourceRow(views_.tables.link_view, link ? views_.tables.links->rowOf(link->first, link->second) : -1);
}

void ReviewPresenter::showPickedCell() {
  const std::optional<CellId> cell = selection_.cell();
  selectSourceRow(views_.tables.cell_view, cell ? views_.tables.cells->rowOf(*cell) : -1);
}

void ReviewPresenter::pickPose(PoseId pose) {
  const Reconstruction* shown = controller_.reconstruction().get();
  QTableView* view = views_.tables.pose_view;
  for (std::size_t row = 0; shown && row < shown->poses.size(); ++row) {
    if (shown->poses[row].pose == pose) view->selectRow(shownRow(view, static_cast<int>(row)).row());
  }
}

void ReviewPresenter::showFinding(const Finding& finding) {
  if (!finding.poses.empty()) pickPose(finding.poses.front());
  if (finding.cells.size() >= 2 && finding.ports.size() >= 2) {
    selection_.seekLink({finding.cells[0], finding.ports[0]}, {finding.cells[1], finding.ports[1]});
  } else if (!finding.cells.empty()) {
    selection_.seekCell(finding.cells.front());
  }
}

/// A row that is picked already may have been scrolled away.
void ReviewPresenter::scrollToPicked() {
  for (QTableView* view : {views_.tables.cell_view, views_.tables.link_view}) {
    const QModelIndexList rows = view->selectionModel()->selectedRows();
    if (!rows.isEmpty()) view->scrollTo(rows.front());
  }
}

/// Where position and orientation are least certain at two cells, the second time shows the other one.
void ReviewPresenter::showWorstCell() {
  const Reconstruction* result = controller_.reconstruction().get();
  const std::vector<CellId> worst = result ? worstCells(*result) : std::vector<CellId>();
  if (worst.empty()) return;
  selection_.seekCell(selection_.cell() == worst.front() ? worst.back() : worst.front());
  showFigures(true);
  // So that the arrow keys go on to its neighbours.
  QWidget* const walkable = views_.patch->isVisible() ? static_cast<QWidget*>(views_.patch) : views_.graph;
  walkable->setFocus(Qt::ShortcutFocusReason);
}

void ReviewPresenter::showFigures(bool shown) {
  views_.patch->setFiguresShown(shown);
  // Where there is no 3D view, or another view in its place, the graph has them.
  const bool is_seen = views_.patch->isVisible() && views_.patch->areFiguresShown();
  if (shown && !is_seen) views_.graph->showFigures();
}

void ReviewPresenter::showWorstFinding() {
  const Finding* worst = controller_.reconstruction() ? worstFinding(*controller_.reconstruction()) : nullptr;
  if (!worst) return;
  views_.steps->openStep(static_cast<int>(GuideStep::Review));
  for (int row = 0; row < views_.tables.findings->rowCount(); ++row) {
    if (&views_.tables.findings->findingAt(row) == worst) views_.tables.finding_view->selectRow(row);
  }
  showFinding(*worst);
}

}  // namespace hexoderm
