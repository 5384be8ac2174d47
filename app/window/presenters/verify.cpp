#include "app/window/presenters/presenters.h"

#include "app/window/presenters/file_presenter.h"
#include "app/window/session/verification.h"
#include "app/window/toolkit/dialogs.h"

namespace hexoderm {
namespace {

/// One of the overlays over the 3D view; the others stay.
template <class T>
void lay(PatchView& patch, std::shared_ptr<const T> PatchOverlays::*overlay, std::shared_ptr<const T> value) {
  PatchOverlays overlays = patch.overlays();
  overlays.*overlay = std::move(value);
  patch.setOverlays(overlays);
}

void connectResults(const WindowParts& parts, const Verification& verification) {
  VerifyPanel* const panel = parts.views.verify_panel;
  PatchView* const patch = parts.views.patch;
  QObject::connect(&verification, &Verification::runningChanged, panel, &VerifyPanel::setRunning);
  QObject::connect(&verification, &Verification::heldOut, panel, &VerifyPanel::showHoldOut);
  QObject::connect(&verification, &Verification::loopsFound, panel, &VerifyPanel::showLoops);
  QObject::connect(&verification, &Verification::surfacesFitted, panel, &VerifyPanel::showSurfaces);
  QObject::connect(&verification, &Verification::compared, panel, &VerifyPanel::showComparison);
  QObject::connect(&verification, &Verification::oldCalibrationChecked, panel, &VerifyPanel::showOldCalibration);
  QObject::connect(&verification, &Verification::failed, panel, &VerifyPanel::showFailure);
  QObject::connect(panel, &VerifyPanel::surfaceShown, patch, [patch](const std::optional<SurfaceEvaluation>& surface) {
    lay(*patch, &PatchOverlays::surface, surface ? std::make_shared<const SurfaceEvaluation>(*surface) : nullptr);
  });
  QObject::connect(panel, &VerifyPanel::loopShown, patch, [patch](const std::optional<LoopEvaluation>& loop) {
    lay(*patch, &PatchOverlays::loop, loop ? std::make_shared<const LoopEvaluation>(*loop) : nullptr);
  });
  QObject::connect(panel, &VerifyPanel::comparisonShown, patch, [patch](const std::vector<Comparison>& comparison) {
    lay(*patch, &PatchOverlays::comparison, std::make_shared<const std::vector<Comparison>>(comparison));
  });
}

}  // namespace

void connectVerify(const WindowParts& parts, Verification& verification, FilePresenter& files) {
  VerifyPanel* const panel = parts.views.verify_panel;
  SessionController& controller = parts.controller;
  for (CsvActions* actions : panel->csvActions()) files.saveTablesOf(actions);
  QObject::connect(panel, &VerifyPanel::holdOutRequested, &verification, [&controller, &verification](PoseId pose) {
    if (controller.session()) verification.runHoldOut(controller.session()->snapshot(), pose);
  });
  QObject::connect(panel, &VerifyPanel::cancelRequested, &verification, &Verification::cancel);
  QObject::connect(panel, &VerifyPanel::surfaceRequested, &verification, &Verification::setSurface);
  QObject::connect(panel, &VerifyPanel::surfaceDropped, &verification, &Verification::dropSurface);
  QObject::connect(panel, &VerifyPanel::comparisonRequested, &verification, &Verification::compareWith);
  QObject::connect(panel, &VerifyPanel::comparisonDropped, &verification, &Verification::dropComparison);
  QObject::connect(panel, &VerifyPanel::oldCalibrationRequested, &verification, &Verification::checkOldCalibration);
  QObject::connect(panel, &VerifyPanel::oldCalibrationDropped, &verification, &Verification::dropOldCalibration);
  QObject::connect(panel, &VerifyPanel::comparisonFileWanted, &parts.wires, [&parts, panel] {
    parts.askToRead("comparisonDialog", WindowParts::tr("Compare with an earlier calibration"),
                    WindowParts::tr("Calibrations and sessions (*.calibration.json *.hexo *.session.json *.xml)"),
                    [panel](const QString& path) { panel->compareWith(path); });
  });
  QObject::connect(panel, &VerifyPanel::oldCalibrationWanted, &parts.wires, [&parts, panel] {
    parts.askToRead("oldCalibrationDialog", WindowParts::tr("Check an old calibration"),
                    WindowParts::tr("Calibrations and sessions (*.calibration.json *.hexo *.session.json)"),
                    [panel](const QString& path) { panel->checkOldCalibration(path); });
  });
  connectResults(parts, verification);
  QObject::connect(&controller, &SessionController::reconstructionChanged, &verification,
                   [&controller, &verification, panel] {
                     const Session* session = controller.session();
                     panel->setHasReadings(session != nullptr);
                     verification.setToday(session != nullptr ? session->snapshot() : nullptr);
                   });
  // What one skin was compared with says nothing about the next.
  QObject::connect(&controller, &SessionController::opened, panel, &VerifyPanel::dropComparison);
  QObject::connect(&controller, &SessionController::opened, panel, &VerifyPanel::dropOldCalibration);
}

}  // namespace hexoderm
