#pragma once

#include "app/window/guide/guide.h"
#include "app/window/presenters/presenter.h"
#include "app/window/presenters/result_presenter.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/capture/capture_words.h"

#include <Eigen/Core>

#include <QElapsedTimer>
#include <cstdint>
#include <optional>
#include <utility>

namespace hexoderm {

/// Shows how the poses are captured: the part in the hand, the pose that is wanted next, the directions that were seen.
class CapturePresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::CapturePresenter)

 public:
  CapturePresenter(const WindowParts& parts, const ResultPresenter& results) : Presenter(parts) {
    const LiveSource& live = controller.liveSession().source();
    connect(&live, &LiveSource::previewChanged, this, &CapturePresenter::showMoment);
    connect(&live, &LiveSource::statusChanged, this, &CapturePresenter::showSource);
    connect(&live, &LiveSource::holdChanged, this, &CapturePresenter::showHold);
    const LiveSession& live_session = controller.liveSession();
    connect(&live_session, &LiveSession::poseTaken, this,
            [this](const CapturedPose& captured) { views.capture_panel->showWriting(captured.pose->id); });
    connect(&live_session, &LiveSession::poseKept, this, &CapturePresenter::showCaptured);
    connect(&live_session, &LiveSession::poseLost, views.capture_panel, &CapturePanel::endWriting);
    connect(&controller.liveSession(), &LiveSession::nextPoseChanged, this, &CapturePresenter::showNextPose);
    connect(views.steps, &StepPanel::opened, this, &CapturePresenter::followPart);
    connect(views.patch, &PatchView::turnRequested, &controller.liveSession(), &LiveSession::turnTo);
    connect(&selection, &Selection::changed, this, [this] { views.stillness->setCell(selection.cell()); });
    connect(&results, &ResultPresenter::handedOut, this, &CapturePresenter::showCoverage);
    connectCommands();
    connectPreferences();
  }

 private:
  void connectCommands() {
    connect(actions.turn, &QAction::triggered, &controller.liveSession(), &LiveSession::turnToNextPose);
    connect(actions.automatic, &QAction::triggered, &controller.liveSession(), &LiveSession::setAutomatic);
    connect(actions.capture, &QAction::triggered, &controller.liveSession(), &LiveSession::captureNow);
    connect(actions.skip_pose, &QAction::triggered, &controller.liveSession(), &LiveSession::skipPose);
    connect(actions.robot, &QAction::triggered, &controller.liveSession(), &LiveSession::setRobot);
    connect(actions.live_mode, &QAction::triggered, &controller.liveMode(), &LiveMode::setOn);
    connect(actions.show_next_pose, &QAction::triggered, this, [this] {
      views.steps->openStep(static_cast<int>(GuideStep::Capture));
      views.patch->fit();
    });
  }

  void connectPreferences() {
    const auto follow = [this](Switch changed) {
      if (changed == Switch::Tone) views.tone->setEnabled(preferences.isOn(Switch::Tone));
      if (changed == Switch::ReducedMotion) views.patch->setAnimated(!preferences.isOn(Switch::ReducedMotion));
    };
    follow(Switch::Tone);
    follow(Switch::ReducedMotion);
    connect(&preferences, &Preferences::switched, this, follow);
  }

  void showSource() {
    const LiveSource& source = controller.liveSession().source();
    views.capture_panel->setSource(source.isRunning() ? std::optional(source.status()) : std::nullopt);
    if (isReading()) return;
    // The last readings of a skin that does not send are not those of this moment.
    current_up_.reset();
    views.stillness->clear();
    views.coverage->setCurrent({});
    followPart();
    showAdvice();
  }

  /// The skin sends, so that what was read last is what there is at this moment.
  bool isReading() const {
    const LiveSource& source = controller.liveSession().source();
    return source.isRunning() && source.status().state == SourceState::Streaming;
  }

  void showHold() {
    const HoldStatus& hold = controller.liveSession().source().hold();
    views.capture_panel->setHold(hold);
    if (hold.restarts > restarts_) views.tone->playStartsOver();
    restarts_ = hold.restarts;
  }

  void showCaptured(const CapturedPose& captured) {
    views.tone->playCaptured();
    views.stillness->addCaptured(captured.pose->id, captured.end_s);
    views.capture_panel->showCaptured(
        captured.pose->id, captured.repeats ? tr("It repeats pose %1.").arg(captured.repeats->value()) : QString());
  }

  /// Of the result, or nothing without one.
  void showCoverage() {
    const std::shared_ptr<const Reconstruction>& reconstruction = controller.reconstruction();
    std::vector<std::shared_ptr<const PoseCapture>> captures;
    if (controller.session()) {
      for (const SessionPose& pose : controller.session()->poses()) captures.push_back(pose.capture);
    }
    const PoseCoverage coverage = reconstruction ? coverageOf(*reconstruction, captures) : PoseCoverage{};
    views.coverage->setCoverage(coverage);
    panels.coverage().setRemark(reconstruction ? poseCountText(coverage) : QString());
  }

  void showNextPose() {
    const std::shared_ptr<const Reconstruction>& result = controller.reconstruction();
    const std::optional<PoseAdvice>& advice = controller.liveSession().nextPose();
    const bool known = advice && result;
    views.coverage->setNext(known && controller.liveSession().isNextPoseWanted() ? std::optional(advice->up)
                                                                                 : std::nullopt);
    showAdvice();
    followPart();
  }

  void showAdvice() {
    const std::shared_ptr<const Reconstruction>& result = controller.reconstruction();
    const std::optional<PoseAdvice>& advice = controller.liveSession().nextPose();
    const std::optional<NextPose> next =
        advice && result ? describeNextPose(*advice, *result, current_up_) : std::nullopt;
    views.capture_panel->setAdvice(next);
    told_cell_ = next && next->isWanted() ? std::optional(next->target.cell) : std::nullopt;
    PatchMoment moment = views.patch->moment();
    moment.told_cell = follows_part_ ? told_cell_ : std::nullopt;
    moment.next_turn = next ? turnAngleText(*next).toStdString() : std::string();
    views.patch->setMoment(moment);
  }

  void showMoment() {
    const SkinPreview& preview = controller.liveSession().source().preview();
    const std::shared_ptr<const Reconstruction>& result = controller.reconstruction();
    current_up_ = result ? currentUp(*result, preview.means) : std::nullopt;
    views.stillness->add(controller.liveSession().source().hold(), preview);
    views.coverage->setCurrent(current_up_);
    followPart();
    // The angle to the next pose changes with every reading, but sentences that flicker can't be read.
    constexpr qint64 kReadable_ms = 400;
    if (!advice_age_.isValid() || advice_age_.elapsed() > kReadable_ms) {
      advice_age_.start();
      if (result && controller.liveSession().nextPose()) showAdvice();
    }
  }

  /// In the step Capture the picture turns as the part is turned.
  void followPart() {
    // In the other steps the picture is the operator's own to turn.
    const bool capturing = controller.liveSession().isLive() && !controller.liveMode().isOn() &&
                           views.steps->openIndex() == static_cast<int>(GuideStep::Capture);
    if (std::exchange(follows_part_, capturing) != capturing) {
      if (capturing) {
        views.patch->keepView();
      } else {
        views.patch->returnToKeptView();
      }
    }
    views.patch->setTurnable(capturing && controller.liveSession().canTurn());
    PatchMoment moment = views.patch->moment();
    const SkinPreview& preview = controller.liveSession().source().preview();
    moment.readings = isReading() ? readingsOf(preview.means, preview.temperatures) : nullptr;
    moment.up_o = capturing ? current_up_ : std::nullopt;
    const bool shows_next = capturing && controller.liveSession().isNextPoseWanted();
    moment.told_cell = shows_next ? told_cell_ : std::nullopt;
    moment.next_up_o = shows_next ? std::optional(controller.liveSession().nextPose()->up) : std::nullopt;
    views.patch->setMoment(moment);
  }

  std::optional<Eigen::Vector3d> current_up_;  ///< of the part just now, in the frame of the largest patch
  QElapsedTimer advice_age_;
  bool follows_part_ = false;
  std::optional<CellId> told_cell_;  ///< the cell that the advice speaks of
  std::uint64_t restarts_ = 0;       ///< of captures, as the recorder last said
};

}  // namespace hexoderm
