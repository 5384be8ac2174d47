#include "app/window/presenters/capture_presenter.h"

#include "app/window/guide/actions.h"
#include "app/window/guide/guide.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "widgets/capture/capture_panel.h"
#include "widgets/capture/capture_tone.h"
#include "widgets/capture/capture_words.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/selection.h"
#include "widgets/controls/step_panel.h"
#include "widgets/patch/patch_view.h"

#include <utility>

namespace hexoderm {

CapturePresenter::CapturePresenter(const Views& views, SessionController& controller, const WindowActions& actions,
                                   const Selection& selection, const Preferences& preferences)
    : views_(views), controller_(controller) {
  const LiveSource& live = controller_.liveSession().source();
  connect(&live, &LiveSource::previewChanged, this, &CapturePresenter::showMoment);
  connect(&live, &LiveSource::statusChanged, this, &CapturePresenter::showSource);
  connect(&live, &LiveSource::holdChanged, this, &CapturePresenter::showHold);
  const LiveSession& live_session = controller_.liveSession();
  connect(&live_session, &LiveSession::poseTaken, this,
          [this](const CapturedPose& captured) { views_.panel.showWriting(captured.pose->id); });
  connect(&live_session, &LiveSession::poseKept, this, &CapturePresenter::showCaptured);
  connect(&live_session, &LiveSession::poseLost, &views_.panel, &CapturePanel::endWriting);
  connect(&controller_.poseGuide(), &PoseGuide::nextPoseChanged, this, &CapturePresenter::showNextPose);
  connect(&views_.steps, &StepPanel::opened, this, &CapturePresenter::followPart);
  connect(&views_.patch, &PatchView::turnRequested, &controller_.poseGuide(), &PoseGuide::turnTo);
  connect(&selection, &Selection::changed, this, [this, &selection] { views_.stillness.setCell(selection.cell()); });
  connectCommands(actions);
  connectPreferences(preferences);
}

void CapturePresenter::connectCommands(const WindowActions& actions) {
  connect(actions.turn, &QAction::triggered, &controller_.poseGuide(), &PoseGuide::turnToNextPose);
  connect(actions.automatic, &QAction::triggered, &controller_.liveSession(), &LiveSession::setAutomatic);
  connect(actions.capture, &QAction::triggered, &controller_.liveSession(), &LiveSession::captureNow);
  connect(actions.skip_pose, &QAction::triggered, &controller_.poseGuide(), &PoseGuide::skipPose);
  connect(actions.robot, &QAction::triggered, &controller_.poseGuide(), &PoseGuide::setRobot);
  connect(actions.live_mode, &QAction::triggered, &controller_.liveMode(), &LiveMode::setOn);
  connect(actions.show_next_pose, &QAction::triggered, this, [this] {
    views_.steps.openStep(static_cast<int>(GuideStep::Capture));
    views_.patch.fit();
  });
}

void CapturePresenter::connectPreferences(const Preferences& preferences) {
  views_.tone.setEnabled(preferences.tone());
  views_.patch.setAnimated(!preferences.reducedMotion());
  connect(&preferences, &Preferences::toneChanged, &views_.tone, &CaptureTone::setEnabled);
  connect(&preferences, &Preferences::reducedMotionChanged, this,
          [this](bool reduced) { views_.patch.setAnimated(!reduced); });
}

void CapturePresenter::showSource() {
  const LiveSource& source = controller_.liveSession().source();
  views_.panel.setSource(source.isRunning() ? std::optional(source.status()) : std::nullopt);
  if (isReading()) return;
  // The last readings of a skin that does not send are not those of this moment.
  current_up_.reset();
  views_.stillness.clear();
  views_.coverage.setCurrent({});
  followPart();
  showAdvice();
}

bool CapturePresenter::isReading() const {
  const LiveSource& source = controller_.liveSession().source();
  return source.isRunning() && source.status().state == SourceState::Streaming;
}

void CapturePresenter::showHold() {
  const HoldStatus& hold = controller_.liveSession().source().hold();
  views_.panel.setHold(hold);
  if (hold.restarts > restarts_) views_.tone.playStartsOver();
  restarts_ = hold.restarts;
}

void CapturePresenter::showCaptured(const CapturedPose& captured) {
  views_.tone.playCaptured();
  views_.stillness.addCaptured(captured.pose->id, captured.end_s);
  views_.panel.showCaptured(captured.pose->id,
                            captured.repeats ? tr("It repeats pose %1.").arg(captured.repeats->value()) : QString());
}

void CapturePresenter::setReconstruction(const std::shared_ptr<const Reconstruction>& reconstruction) {
  std::vector<std::shared_ptr<const PoseCapture>> captures;
  if (controller_.session()) {
    for (const SessionPose& pose : controller_.session()->poses()) captures.push_back(pose.capture);
  }
  const PoseCoverage coverage = reconstruction ? coverageOf(*reconstruction, captures) : PoseCoverage{};
  views_.coverage.setCoverage(coverage);
  views_.coverage_dock.setRemark(reconstruction ? poseCountInWords(coverage) : QString());
}

void CapturePresenter::showNextPose() {
  const std::shared_ptr<const Reconstruction>& result = controller_.reconstruction();
  const std::optional<PoseAdvice>& advice = controller_.poseGuide().nextPose();
  const bool known = advice && result;
  views_.coverage.setNext(known && controller_.poseGuide().isNextPoseWanted() ? std::optional(advice->up)
                                                                              : std::nullopt);
  showAdvice();
  followPart();
}

void CapturePresenter::showAdvice() {
  const std::shared_ptr<const Reconstruction>& result = controller_.reconstruction();
  const std::optional<PoseAdvice>& advice = controller_.poseGuide().nextPose();
  const std::optional<NextPose> next =
      advice && result ? describeNextPose(*advice, *result, current_up_) : std::nullopt;
  views_.panel.setAdvice(next);
  told_cell_ = next && next->isWanted() ? std::optional(next->target.cell) : std::nullopt;
  PatchMoment moment = views_.patch.moment();
  moment.told_cell = follows_part_ ? told_cell_ : std::nullopt;
  moment.next_turn = next ? turnAngleInWords(*next).toStdString() : std::string();
  views_.patch.setMoment(moment);
}

void CapturePresenter::showMoment() {
  const SkinPreview& preview = controller_.liveSession().source().preview();
  const std::shared_ptr<const Reconstruction>& result = controller_.reconstruction();
  current_up_ = result ? currentUp(*result, preview.means) : std::nullopt;
  views_.stillness.add(controller_.liveSession().source().hold(), preview);
  views_.coverage.setCurrent(current_up_);
  followPart();
  // The angle to the next pose changes with every reading, but sentences that flicker can't be read.
  constexpr qint64 kReadable_ms = 400;
  if (!advice_age_.isValid() || advice_age_.elapsed() > kReadable_ms) {
    advice_age_.start();
    if (result && controller_.poseGuide().nextPose()) showAdvice();
  }
}

void CapturePresenter::followPart() {
  // In the other steps the picture is the operator's own to turn.
  const bool capturing = controller_.liveSession().isLive() && !controller_.liveMode().isOn() &&
                         views_.steps.openIndex() == static_cast<int>(GuideStep::Capture);
  if (std::exchange(follows_part_, capturing) != capturing) {
    if (capturing) {
      views_.patch.keepView();
    } else {
      views_.patch.returnToKeptView();
    }
  }
  views_.patch.setTurnable(capturing && controller_.liveSession().canTurn());
  PatchMoment moment = views_.patch.moment();
  const SkinPreview& preview = controller_.liveSession().source().preview();
  moment.readings = isReading() ? readingsOf(preview.means, preview.temperatures) : nullptr;
  moment.up_o = capturing ? current_up_ : std::nullopt;
  const bool shows_next = capturing && controller_.poseGuide().isNextPoseWanted();
  moment.told_cell = shows_next ? told_cell_ : std::nullopt;
  moment.next_up_o = shows_next ? std::optional(controller_.poseGuide().nextPose()->up) : std::nullopt;
  views_.patch.setMoment(moment);
}

}  // namespace hexoderm
