// The part of MainWindow about capturing: the step's panel, the directions seen, the part in the hand, the tones.
#include "app/window/main_window/main_window.h"
#include "app/window/main_window/window_shell.h"
#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "widgets/capture/capture_panel.h"
#include "widgets/capture/capture_tone.h"
#include "widgets/capture/capture_words.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/step_panel.h"
#include "widgets/patch/patch_view.h"

#include <utility>

namespace hexoderm {

void MainWindow::connectCapture() {
  step_panel_->setBody(static_cast<int>(GuideStep::Capture), capture_panel_);
  const LiveSource& live = controller_.liveSession().source();
  connect(&live, &LiveSource::previewChanged, this, &MainWindow::showMoment);
  connect(&live, &LiveSource::statusChanged, this, [this] {
    const LiveSource& source = controller_.liveSession().source();
    capture_panel_->setSource(source.isRunning() ? std::optional(source.status()) : std::nullopt);
    if (source.isRunning()) return;
    stillness_view_->clear();
    PatchMoment moment = patch_view_->moment();
    moment.readings = nullptr;
    moment.up_o.reset();
    patch_view_->setMoment(moment);
    coverage_view_->setCurrent({});
  });
  connect(&live, &LiveSource::holdChanged, this, [this] {
    const HoldStatus& hold = controller_.liveSession().source().hold();
    capture_panel_->setHold(hold);
    if (hold.restarts > restarts_) tone_->playStartsOver();
    restarts_ = hold.restarts;
  });
  connect(&controller_.liveSession(), &LiveSession::poseTaken, this,
          [this](const CapturedPose& captured) { capture_panel_->showWriting(captured.pose->id); });
  connect(&controller_.liveSession(), &LiveSession::poseKept, this, [this](const CapturedPose& captured) {
    tone_->playCaptured();
    stillness_view_->addCaptured(captured.pose->id, captured.end_s);
    capture_panel_->showCaptured(
        captured.pose->id, captured.repeats ? tr("It repeats pose %1.").arg(captured.repeats->value()) : QString());
  });
  connect(&controller_.liveSession(), &LiveSession::poseLost, capture_panel_, &CapturePanel::endWriting);
  connect(&controller_.poseGuide(), &PoseGuide::nextPoseChanged, this, &MainWindow::showNextPose);
  connect(&controller_, &SessionController::reconstructionChanged, this, &MainWindow::showCoverage);
  connect(step_panel_, &StepPanel::opened, this, &MainWindow::followPart);
  connect(step_panel_, &StepPanel::opened, this, &MainWindow::refreshLive);
  connect(coverage_view_, &CoverageView::posePicked, this, &MainWindow::pickPose);
  connect(patch_view_, &PatchView::turnRequested, &controller_.poseGuide(), &PoseGuide::turnTo);
  connect(&selection_, &Selection::changed, stillness_view_, [this] { stillness_view_->setCell(selection_.cell()); });

  const Preferences& preferences = shell_->preferences();
  tone_->setEnabled(preferences.tone());
  patch_view_->setAnimated(!preferences.reducedMotion());
  connect(&preferences, &Preferences::toneChanged, tone_, &CaptureTone::setEnabled);
  connect(&preferences, &Preferences::reducedMotionChanged, patch_view_,
          [this](bool reduced) { patch_view_->setAnimated(!reduced); });
}

void MainWindow::showCoverage(const std::shared_ptr<const Reconstruction>& reconstruction) {
  std::vector<std::shared_ptr<const PoseCapture>> captures;
  if (controller_.session()) {
    for (const SessionPose& pose : controller_.session()->poses()) captures.push_back(pose.capture);
  }
  const PoseCoverage coverage = reconstruction ? coverageOf(*reconstruction, captures) : PoseCoverage{};
  coverage_view_->setCoverage(coverage);
  coverage_dock_->setRemark(reconstruction ? poseCountInWords(coverage) : QString());
}

void MainWindow::showNextPose() {
  const std::shared_ptr<const Reconstruction>& result = controller_.reconstruction();
  const std::optional<PoseAdvice>& advice = controller_.poseGuide().nextPose();
  const bool known = advice && result;
  coverage_view_->setNext(known && controller_.poseGuide().isNextPoseWanted() ? std::optional(advice->up)
                                                                              : std::nullopt);
  showAdvice();
  followPart();
}

void MainWindow::showAdvice() {
  const std::shared_ptr<const Reconstruction>& result = controller_.reconstruction();
  const std::optional<PoseAdvice>& advice = controller_.poseGuide().nextPose();
  const std::optional<NextPose> next =
      advice && result ? describeNextPose(*advice, *result, current_up_) : std::nullopt;
  capture_panel_->setAdvice(next);
  PatchMoment moment = patch_view_->moment();
  moment.next_turn = next ? turnAngleInWords(*next).toStdString() : std::string();
  patch_view_->setMoment(moment);
}

void MainWindow::showMoment() {
  const SkinPreview& preview = controller_.liveSession().source().preview();
  const std::shared_ptr<const Reconstruction>& result = controller_.reconstruction();
  current_up_ = result ? currentUp(*result, preview.means) : std::nullopt;
  stillness_view_->add(controller_.liveSession().source().hold(), preview);
  coverage_view_->setCurrent(current_up_);
  followPart();
  // How far it is to the next pose, a few times a second: sentences that flicker can't be read.
  constexpr qint64 kReadable_ms = 400;
  if (!advice_age_.isValid() || advice_age_.elapsed() > kReadable_ms) {
    advice_age_.start();
    if (result && controller_.poseGuide().nextPose()) showAdvice();
  }
}

void MainWindow::followPart() {
  // In the other steps the picture is the operator's own to turn.
  const bool capturing = controller_.liveSession().isLive() && !controller_.liveMode().isOn() &&
                         step_panel_->openIndex() == static_cast<int>(GuideStep::Capture);
  if (std::exchange(follows_part_, capturing) != capturing) {
    if (capturing) {
      patch_view_->keepView();
    } else {
      patch_view_->returnToKeptView();
    }
  }
  patch_view_->setTurnable(capturing && controller_.liveSession().canTurn());
  PatchMoment moment = patch_view_->moment();
  const SkinPreview& preview = controller_.liveSession().source().preview();
  moment.readings = readingsOf(preview.means, preview.temperatures);
  moment.up_o = capturing ? current_up_ : std::nullopt;
  const bool shows_next = capturing && controller_.poseGuide().isNextPoseWanted();
  moment.next_up_o = shows_next ? std::optional(controller_.poseGuide().nextPose()->up) : std::nullopt;
  patch_view_->setMoment(moment);
}

}  // namespace hexoderm
