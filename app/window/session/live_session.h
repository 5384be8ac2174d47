#pragma once

#include "app/window/session/live_source.h"
#include "hexoderm/base/latest_worker.h"
#include "hexoderm/capture/capture_workflow.h"
#include "hexoderm/solve/reconstruction_worker.h"

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>

namespace hexoderm {

class SessionController;

/// The request of the dialog that connects.
struct ConnectRequest {
  QString address;  ///< in the form that openSkinSource() takes
  QString path;     ///< the new *.hexo that the poses are kept in; empty: a scratch file, until it is saved
  bool continue_session = false;  ///< instead, the poses join the session that is open and kept in a file
  bool demo = false;              ///< the simulated skin that everything can be tried with
};

/// The connected skin, whose poses the open session grows by. CaptureWorkflow decides what becomes of them, and which
/// pose is advised next, to a person or to the robot.
class LiveSession : public QObject, private CaptureOwner {
  Q_OBJECT

 public:
  /// `controller` outlives this object.
  explicit LiveSession(SessionController& controller);

  /// The skin that is connected, or about to be.
  [[nodiscard]] const LiveSource& source() const { return source_; }
  /// The open session grows by the poses of the connected skin.
  [[nodiscard]] bool isLive() const { return course_.isOn() && source_.isRunning(); }
  /// The session is that of the simulated skin that everything can be tried with.
  [[nodiscard]] bool isDemo() const;
  /// The device can be asked to turn itself.
  [[nodiscard]] bool canTurn() const { return isLive() && course_.canTurn(); }
  [[nodiscard]] bool isAutomatic() const { return automatic_; }
  /// The pose that the next capture replaces.
  [[nodiscard]] std::optional<PoseId> recapturing() const { return course_.recapturing(); }
  /// The cell whose light was switched on.
  [[nodiscard]] std::optional<CellId> litCell() const { return lit_; }

  /// The pose that would help most, in the frame of the largest patch; none before the first result, or where no skin
  /// is connected.
  [[nodiscard]] const std::optional<PoseAdvice>& nextPose() const { return course_.nextPose(); }
  /// Following that advice would help: not for the first pose, which may be any, nor where there are enough.
  [[nodiscard]] bool isNextPoseWanted() const { return course_.isNextPoseWanted(); }
  /// The connected skin should be held for another pose, as the result's assessment says.
  [[nodiscard]] bool wantsMorePoses() const {
    return isLive() && source_.status().state != SourceState::Ended && course_.wantsMorePoses();
  }
  /// The device turns itself from pose to pose until there are enough.
  [[nodiscard]] bool isRobotOn() const { return course_.isRobotOn(); }

  // For the other parts of the session.

  /// Another session is opened, or none.
  void forget();
  void noteChange();
  void noteResult();
  void setStored(hexoderm::PoseId pose, const hexoderm::StoreOutcome& outcome) { course_.setStored(pose, outcome); }
  void keepIn(KeptIn where) { course_.setKeptIn(where); }

 public slots:
  void startDemo();
  /// The session that is open stays until the skin has described itself.
  void connectTo(const hexoderm::ConnectRequest& request);
  /// Disconnects; captured poses stay.
  void disconnectSource();
  /// The next readings become a pose, moved or not. Nothing happens where no skin is connected.
  void captureNow();
  void setAutomatic(bool automatic);
  /// The next capture takes the place of this pose.
  void recapturePose(std::size_t index);
  void cancelRecapture();
  /// Lights a cell of the connected skin, and darkens the one before.
  void lightCell(std::optional<hexoderm::CellId> cell);
  /// Sets the options of captures, from the next connection on.
  void setRecorderOptions(const hexoderm::PoseRecorderOptions& options) { recorder_options_ = options; }
  /// Asks the device to turn itself to where the next pose helps most.
  void turnToNextPose();
  /// Asks the device to turn until `up_o` (frame of the largest patch) points up.
  void turnTo(const Eigen::Vector3d& up_o);
  /// The part can't be brought there: advises the next best pose.
  void skipPose() { course_.skipPose(); }
  void setRobot(bool on) { startRobot(on, 0); }
  /// The same until the session has so many poses, whether they are wanted or not.
  void letRobotTake(std::size_t poses) { startRobot(true, poses); }

 signals:
  /// A pose is in the session and is being written; it is not captured yet.
  void poseTaken(const hexoderm::CapturedPose& captured);
  /// A pose is captured: it is on disk, or the operator knows that nothing is.
  void poseKept(const hexoderm::CapturedPose& captured);
  /// A pose that was taken can't be written, and nobody will try again.
  void poseLost(hexoderm::PoseId pose);
  /// The same as poseKept(), in words; `remarkable` if the operator should read them.
  void captured(const QString& text, bool remarkable);
  void nextPoseChanged();
  /// No skin is connected any more, or another one is being.
  void ended();

 private:
  void perform(const std::vector<SessionEdit>& edits) override;
  std::uint32_t send(const SkinCommand& command) override { return source_.send(command); }
  void retryWriting() override;
  void onWorkflowEvent(const WorkflowEvent& event) override;

  void forgetSource();
  void showSkin(const SkinDescription& skin);
  [[nodiscard]] bool begin(const SkinDescription& skin);
  [[nodiscard]] bool join(const SkinDescription& skin);
  void announce(const PoseKept& kept);
  void announce(const TurnRefused& refused);
  void startRobot(bool on, std::size_t poses);
  void advise(const AdviceQuestion& question);
  /// Those that the next capture may repeat.
  [[nodiscard]] std::vector<std::shared_ptr<const PoseCapture>> earlierPoses() const;

  SessionController& controller_;
  CaptureWorkflow course_;
  PoseRecorderOptions recorder_options_;
  ConnectRequest request_;
  std::uint64_t request_revision_ = 0;  ///< SessionController::submittedRevision() when it was made
  bool demo_ = false;
  bool automatic_ = true;
  std::optional<CellId> lit_;
  LiveSource source_;
  LatestWorker adviser_;  // last: its thread has ended before what it reports to goes
};

/// The skin as its readings of this moment alone show it, instead of the session's result.
class LiveMode : public QObject {
  Q_OBJECT

 public:
  /// `controller` outlives this object.
  explicit LiveMode(SessionController& controller);

  [[nodiscard]] bool isOn() const { return is_on_; }

  // For the other parts of the session.

  /// Solves the newest readings.
  void solve();
  /// Gives up what waits to be solved.
  void cancel() { worker_.cancel(); }

 public slots:
  /// Stays off where no skin is connected.
  void setOn(bool on);

 signals:
  /// After it ends, the result that was not shown meanwhile is still the same.
  void toggled(bool on);
  /// Every moment that was solved.
  void momentSolved(std::shared_ptr<const hexoderm::Reconstruction> reconstruction);

 private:
  void receive(const ReconstructionOutcome& outcome);

  SessionController& controller_;
  bool is_on_ = false;
  bool fails_ = false;           ///< told once
  ReconstructionWorker worker_;  // last: its thread has ended before what it reports to goes
};

}  // namespace hexoderm
