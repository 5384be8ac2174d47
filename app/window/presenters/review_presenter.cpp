// The part of MainWindow about how good a calibration is: its tables, its residuals, and the checks of the step Verify.
#include "app/window/main_window/main_window.h"
#include "app/window/session/verification.h"
#include "app/window/settings/preferences.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "app/window/toolkit/file_dialog.h"
#include "widgets/controls/step_panel.h"
#include "widgets/patch/patch_view.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/row_picking.h"
#include "widgets/tables/sorted_table.h"
#include "widgets/tables/table_csv.h"
#include "widgets/verify/residual_view.h"
#include "widgets/verify/verify_panel.h"

#include <QTableView>

namespace hexoderm {

void MainWindow::connectVerify() {
  step_panel_->setBody(static_cast<int>(GuideStep::Verify), verify_panel_);
  for (QTableView* view : {pose_view_, link_view_, cell_view_}) SortedTable::enableIn(view);
  const auto serve = [this](CsvActions* actions) {
    connect(actions, &CsvActions::saveRequested, this, [this](const QString& name, const QByteArray& csv) {
      askForPath(tr("Save the table"), name, tr("Tables (*.csv)"), QStringLiteral(".csv"),
                 [this, csv](const QString& path) { controller_.resultFiles().saveTable(csv, path); });
    });
  };
  serve(new CsvActions(pose_view_, QStringLiteral("poses")));
  serve(new CsvActions(link_view_, QStringLiteral("links")));
  serve(new CsvActions(cell_view_, QStringLiteral("cells")));
  serve(new CsvActions(finding_view_, QStringLiteral("findings")));
  serve(new CsvActions(residual_view_->matrix(), QStringLiteral("residuals")));
  for (CsvActions* actions : verify_panel_->csvActions()) serve(actions);

  onPicked(cell_view_, this,
           [this](const QModelIndex& picked) { selection_.selectCell(cell_table_->cellAt(sourceRow(picked))); });
  connect(&selection_, &Selection::changed, this, &MainWindow::showPickedCell);
  connect(residual_view_, &ResidualView::posePicked, this, &MainWindow::pickPose);

  connect(&controller_, &SessionController::reconstructionChanged, verification_, &Verification::setReconstruction);
  connect(verify_panel_, &VerifyPanel::holdOutRequested, this, [this](PoseId pose) {
    if (controller_.session()) verification_->runHoldOut(controller_.session()->snapshot(), pose);
  });
  connect(verify_panel_, &VerifyPanel::cancelRequested, verification_, &Verification::cancel);
  connect(verify_panel_, &VerifyPanel::surfaceRequested, verification_, &Verification::setSurface);
  connect(verify_panel_, &VerifyPanel::comparisonFileWanted, this, &MainWindow::askForComparison);
  connect(verify_panel_, &VerifyPanel::comparisonRequested, verification_, &Verification::compareWith);
  connect(verify_panel_, &VerifyPanel::comparisonDropped, verification_, &Verification::dropComparison);
  connect(verification_, &Verification::runningChanged, verify_panel_, &VerifyPanel::setRunning);
  connect(verification_, &Verification::heldOut, verify_panel_, &VerifyPanel::showHoldOut);
  connect(verification_, &Verification::loopsFound, verify_panel_, &VerifyPanel::showLoops);
  connect(verification_, &Verification::surfacesFitted, verify_panel_, &VerifyPanel::showSurfaces);
  connect(verification_, &Verification::compared, verify_panel_, &VerifyPanel::showComparison);
  connect(verification_, &Verification::failed, verify_panel_, &VerifyPanel::showFailure);
  connect(verify_panel_, &VerifyPanel::surfaceShown, this, [this](const std::optional<SurfaceEvaluation>& surface) {
    PatchOverlays overlays = patch_view_->overlays();
    overlays.surface = surface ? std::make_shared<const SurfaceEvaluation>(*surface) : nullptr;
    patch_view_->setOverlays(overlays);
  });
  connect(verify_panel_, &VerifyPanel::loopShown, this, [this](const std::optional<LoopEvaluation>& loop) {
    PatchOverlays overlays = patch_view_->overlays();
    overlays.loop = loop ? std::make_shared<const LoopEvaluation>(*loop) : nullptr;
    patch_view_->setOverlays(overlays);
  });
  connect(verify_panel_, &VerifyPanel::comparisonShown, this, [this](const std::vector<Comparison>& comparison) {
    PatchOverlays overlays = patch_view_->overlays();
    overlays.comparison = std::make_shared<const std::vector<Comparison>>(comparison);
    patch_view_->setOverlays(overlays);
  });
  // What one skin was compared with says nothing about the next.
  connect(&controller_, &SessionController::opened, verify_panel_, &VerifyPanel::dropComparison);
}

void MainWindow::askForComparison() {
  auto* dialog = new FileDialog(this, tr("Compare with an earlier calibration"), lastFolder(),
                                tr("Calibrations and sessions (*.calibration.json *.hexo *.session.json *.xml)"));
  dialog->setObjectName(QStringLiteral("comparisonDialog"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    rememberFolder(path);
    verify_panel_->compareWith(path);
  });
  openInTurns(dialog);
}

int MainWindow::sourceRow(const QModelIndex& index) {
  const auto* sorted = qobject_cast<const SortedTable*>(index.model());
  return sorted ? sorted->mapToSource(index).row() : index.row();
}

QModelIndex MainWindow::shownRow(const QTableView* view, int row) {
  const auto* sorted = qobject_cast<const SortedTable*>(view->model());
  return sorted ? sorted->mapFromSource(sorted->sourceModel()->index(row, 0)) : view->model()->index(row, 0);
}

void MainWindow::showReview(const std::shared_ptr<const Reconstruction>& reconstruction) {
  cell_table_->setReconstruction(reconstruction);
  residual_view_->setReconstruction(reconstruction);
  verify_panel_->setReconstruction(reconstruction, controller_.session() != nullptr);
  showPickedCell();
}

void MainWindow::showPickedCell() {
  const int row = selection_.cell() ? cell_table_->rowOf(*selection_.cell()) : -1;
  if (row < 0) {
    cell_view_->clearSelection();
    cell_view_->selectionModel()->clearCurrentIndex();
  } else if (const QModelIndex shown = shownRow(cell_view_, row);
             !cell_view_->selectionModel()->isRowSelected(shown.row(), {})) {
    cell_view_->selectRow(shown.row());
  }
}

void MainWindow::pickPose(PoseId pose) {
  const Reconstruction* shown = controller_.reconstruction().get();
  for (std::size_t row = 0; shown && row < shown->poses.size(); ++row) {
    if (shown->poses[row].pose == pose) pose_view_->selectRow(shownRow(pose_view_, static_cast<int>(row)).row());
  }
}

}  // namespace hexoderm
