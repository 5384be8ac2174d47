#include "app/window/presenters/verify_presenter.h"

#include "app/window/presenters/file_presenter.h"
#include "app/window/session/session_controller.h"
#include "app/window/session/verification.h"
#include "app/window/settings/preferences.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "app/window/toolkit/file_dialog.h"
#include "widgets/patch/patch_view.h"
#include "widgets/verify/verify_panel.h"

namespace hexoderm {

VerifyPresenter::VerifyPresenter(const Views& views, const SessionController& controller, Verification& verification,
                                 FilePresenter& files)
    : views_(views), controller_(controller), verification_(verification) {
  VerifyPanel* panel = &views_.panel;
  for (CsvActions* actions : panel->csvActions()) files.saveTablesOf(actions);
  connect(panel, &VerifyPanel::holdOutRequested, this, [this](PoseId pose) {
    if (controller_.session()) verification_.runHoldOut(controller_.session()->snapshot(), pose);
  });
  connect(panel, &VerifyPanel::cancelRequested, &verification_, &Verification::cancel);
  connect(panel, &VerifyPanel::surfaceRequested, &verification_, &Verification::setSurface);
  connect(panel, &VerifyPanel::surfaceDropped, &verification_, &Verification::dropSurface);
  connect(panel, &VerifyPanel::comparisonFileWanted, this, &VerifyPresenter::askForComparison);
  connect(panel, &VerifyPanel::comparisonRequested, &verification_, &Verification::compareWith);
  connect(panel, &VerifyPanel::comparisonDropped, &verification_, &Verification::dropComparison);
  connect(panel, &VerifyPanel::oldCalibrationWanted, this, &VerifyPresenter::askForOldCalibration);
  connect(panel, &VerifyPanel::oldCalibrationRequested, &verification_, &Verification::checkOldCalibration);
  connect(panel, &VerifyPanel::oldCalibrationDropped, &verification_, &Verification::dropOldCalibration);
  connectResults();
  connect(&controller_, &SessionController::reconstructionChanged, panel, [this] {
    const Session* session = controller_.session();
    views_.panel.setHasReadings(session != nullptr);
    verification_.setToday(session != nullptr ? session->snapshot() : nullptr);
  });
  // What one skin was compared with says nothing about the next.
  connect(&controller_, &SessionController::opened, panel, &VerifyPanel::dropComparison);
  connect(&controller_, &SessionController::opened, panel, &VerifyPanel::dropOldCalibration);
}

void VerifyPresenter::connectResults() {
  VerifyPanel* panel = &views_.panel;
  connect(&verification_, &Verification::runningChanged, panel, &VerifyPanel::setRunning);
  connect(&verification_, &Verification::heldOut, panel, &VerifyPanel::showHoldOut);
  connect(&verification_, &Verification::loopsFound, panel, &VerifyPanel::showLoops);
  connect(&verification_, &Verification::surfacesFitted, panel, &VerifyPanel::showSurfaces);
  connect(&verification_, &Verification::compared, panel, &VerifyPanel::showComparison);
  connect(&verification_, &Verification::oldCalibrationChecked, panel, &VerifyPanel::showOldCalibration);
  connect(&verification_, &Verification::failed, panel, &VerifyPanel::showFailure);
  connect(panel, &VerifyPanel::surfaceShown, this, [this](const std::optional<SurfaceEvaluation>& surface) {
    PatchOverlays overlays = views_.patch.overlays();
    overlays.surface = surface ? std::make_shared<const SurfaceEvaluation>(*surface) : nullptr;
    views_.patch.setOverlays(overlays);
  });
  connect(panel, &VerifyPanel::loopShown, this, [this](const std::optional<LoopEvaluation>& loop) {
    PatchOverlays overlays = views_.patch.overlays();
    overlays.loop = loop ? std::make_shared<const LoopEvaluation>(*loop) : nullptr;
    views_.patch.setOverlays(overlays);
  });
  connect(panel, &VerifyPanel::comparisonShown, this, [this](const std::vector<Comparison>& comparison) {
    PatchOverlays overlays = views_.patch.overlays();
    overlays.comparison = std::make_shared<const std::vector<Comparison>>(comparison);
    views_.patch.setOverlays(overlays);
  });
}

void VerifyPresenter::askForComparison() {
  askForFile("comparisonDialog", tr("Compare with an earlier calibration"),
             tr("Calibrations and sessions (*.calibration.json *.hexo *.session.json *.xml)"),
             [this](const QString& path) { views_.panel.compareWith(path); });
}

void VerifyPresenter::askForOldCalibration() {
  askForFile("oldCalibrationDialog", tr("Check an old calibration"),
             tr("Calibrations and sessions (*.calibration.json *.hexo *.session.json)"),
             [this](const QString& path) { views_.panel.checkOldCalibration(path); });
}

void VerifyPresenter::askForFile(const char* name, const QString& title, const QString& filter,
                                 const std::function<void(const QString&)>& take) {
  auto* dialog = new FileDialog(&views_.window, title, lastFolder(), filter);
  dialog->setObjectName(QLatin1String(name));
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [take](const QString& path) {
    rememberFolder(path);
    take(path);
  });
  openInTurns(dialog);
}

}  // namespace hexoderm
