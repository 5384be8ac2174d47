#include "app/window/presenters/presenters.h"

#include "app/window/presenters/file_presenter.h"
#include "app/window/session/verification.h"
#include "app/window/toolkit/file_dialog.h"

namespace hexoderm {
namespace {

/// Runs the checks of the step Verify, as its panel asks for them.
class VerifyPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::VerifyPresenter)

 public:
  VerifyPresenter(const WindowParts& parts, Verification& verification, FilePresenter& files)
      : Presenter(parts), verification_(verification) {
    VerifyPanel* panel = views_.verify_panel;
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
      views_.verify_panel->setHasReadings(session != nullptr);
      verification_.setToday(session != nullptr ? session->snapshot() : nullptr);
    });
    // What one skin was compared with says nothing about the next.
    connect(&controller_, &SessionController::opened, panel, &VerifyPanel::dropComparison);
    connect(&controller_, &SessionController::opened, panel, &VerifyPanel::dropOldCalibration);
  }

 private:
  void connectResults() {
    VerifyPanel* panel = views_.verify_panel;
    connect(&verification_, &Verification::runningChanged, panel, &VerifyPanel::setRunning);
    connect(&verification_, &Verification::heldOut, panel, &VerifyPanel::showHoldOut);
    connect(&verification_, &Verification::loopsFound, panel, &VerifyPanel::showLoops);
    connect(&verification_, &Verification::surfacesFitted, panel, &VerifyPanel::showSurfaces);
    connect(&verification_, &Verification::compared, panel, &VerifyPanel::showComparison);
    connect(&verification_, &Verification::oldCalibrationChecked, panel, &VerifyPanel::showOldCalibration);
    connect(&verification_, &Verification::failed, panel, &VerifyPanel::showFailure);
    connect(panel, &VerifyPanel::surfaceShown, this, [this](const std::optional<SurfaceEvaluation>& surface) {
      lay(&PatchOverlays::surface, surface ? std::make_shared<const SurfaceEvaluation>(*surface) : nullptr);
    });
    connect(panel, &VerifyPanel::loopShown, this, [this](const std::optional<LoopEvaluation>& loop) {
      lay(&PatchOverlays::loop, loop ? std::make_shared<const LoopEvaluation>(*loop) : nullptr);
    });
    connect(panel, &VerifyPanel::comparisonShown, this, [this](const std::vector<Comparison>& comparison) {
      lay(&PatchOverlays::comparison, std::make_shared<const std::vector<Comparison>>(comparison));
    });
  }

  /// One of the overlays over the 3D view; the others stay.
  template <class T>
  void lay(std::shared_ptr<const T> PatchOverlays::*overlay, std::shared_ptr<const T> value) {
    PatchOverlays overlays = views_.patch->overlays();
    overlays.*overlay = std::move(value);
    views_.patch->setOverlays(overlays);
  }

  void askForComparison() {
    askForFile(&window_, "comparisonDialog", tr("Compare with an earlier calibration"), lastFolder(),
               tr("Calibrations and sessions (*.calibration.json *.hexo *.session.json *.xml)"), this,
               [this](const QString& path) {
                 rememberFolder(path);
                 views_.verify_panel->compareWith(path);
               });
  }

  void askForOldCalibration() {
    askForFile(&window_, "oldCalibrationDialog", tr("Check an old calibration"), lastFolder(),
               tr("Calibrations and sessions (*.calibration.json *.hexo *.session.json)"), this,
               [this](const QString& path) {
                 rememberFolder(path);
                 views_.verify_panel->checkOldCalibration(path);
               });
  }

  Verification& verification_;
};

}  // namespace

std::unique_ptr<Presenter> makeVerifyPresenter(const WindowParts& parts, Verification& verification,
                                               FilePresenter& files) {
  return std::make_unique<VerifyPresenter>(parts, verification, files);
}

}  // namespace hexoderm
