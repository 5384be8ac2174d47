#pragma once

#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/session/session_edit.h"
#include "hexoderm/session/session_recorder.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hexoderm {

/// The place of a pose that counts as captured. Memory: the operator was told that no file keeps the session.
enum class KeptIn { File, Memory };

/// The readings of a pose are complete. It is part of the session, it is being written, and it does not count as
/// captured yet.
struct PoseTaken {
  CapturedPose captured;           ///< without its frames
  std::optional<PoseId> replaced;  ///< the pose that was recaptured
};
/// The pose counts as captured.
struct PoseKept {
  CapturedPose captured;  ///< without its frames
  KeptIn where = KeptIn::File;
  Message without_raw{};  ///< why its raw samples are not in the file; empty if they are, or were not wanted
};
/// The pose is not in the file, and nobody will try again.
struct PoseLost {
  PoseId pose;
  Message why;
};
/// The file can't be written, because its disk is full for example. Told once, until something was written again.
struct FileRefused {
  Message why;
};
/// The file was gone from its place, and the whole session was written anew there: see SessionStore::renewIfGone().
struct FileRenewed {
  Message what;
};
/// The device describes itself with other links, or with another cell model; the session has them now, and its poses
/// stay.
struct SkinChanged {
  bool on_joining = false;   ///< when it was connected, compared with the session that it joined
  bool other_model = false;  ///< its cell model is another one
};
/// Everything that the advice for the next pose is computed from.
struct AdviceQuestion {
  std::uint64_t number = 0;
  std::shared_ptr<const Reconstruction> seen;  ///< has a patch
  std::vector<Eigen::Vector3d> unreachable;    ///< unit, frame of the largest patch
};
/// The owner should call CaptureWorkflow::setAdvice() with adviseOn() of this question, now or later.
struct AdviceWanted {
  AdviceQuestion question;
};
/// CaptureWorkflow::nextPose() changed.
struct AdviceChanged {};
/// The device does not turn to where it was asked to; another pose is advised.
struct TurnRefused {
  Message why;
  std::size_t times = 0;  ///< since the robot was switched on, this one included
  bool gave_up = false;   ///< so often that it is not asked again by itself
};
/// There are enough poses, see CaptureWorkflow::isFinished().
struct WorkflowFinished {};

/// Everything that a course tells its owner.
using WorkflowEvent = std::variant<PoseTaken, PoseKept, PoseLost, FileRefused, FileRenewed, SkinChanged, AdviceWanted,
                                   AdviceChanged, TurnRefused, WorkflowFinished>;

/// The answer to an AdviceQuestion.
struct AdviceAnswer {
  std::uint64_t number = 0;  ///< number of the question
  PoseAdvice advice;
  bool is_wanted = false;  ///< NextPose::isWanted()
};
/// Takes a while for many poses. Can run on any thread.
AdviceAnswer adviseOn(const AdviceQuestion& question);

/// The surroundings of a course: the session, the file that keeps it, the connected skin and the display.
/// Its functions are called on the owner's thread by functions of CaptureWorkflow, and what they throw is thrown by
/// these, which have done half their work then: end() or forget() is what is left. Within a SkinListener or an
/// Acknowledge they must not throw: std::terminate.
class CaptureOwner {
 public:
  virtual ~CaptureOwner() = default;
  /// Applies the edits to the session as one step and gives them to the file, if there is one. The outcome of an
  /// AddPose there must be reported to CaptureWorkflow::setStored(), and the change itself to
  /// CaptureWorkflow::noteChange().
  virtual void perform(const std::vector<SessionEdit>& edits) = 0;
  /// SkinSource::send().
  virtual std::uint32_t send(const SkinCommand& command) = 0;
  /// SessionRecorder::retry().
  virtual void retryWriting() = 0;
  virtual void onWorkflowEvent(
      const WorkflowEvent& event) = 0;  ///< something happened, for the owner to show or to answer
};

/// When a course ends, and how it treats its file.
struct CaptureWorkflowOptions {
  std::size_t poses = 0;  ///< poses of the session that are enough; 0: as the result's assessment says
  bool keep_raw = false;  ///< gives the frames of a pose to the file too
  /// How long to wait before a file that can't be written is tried again by tick(). 0: only when the owner tries.
  std::chrono::milliseconds retry_every{0};
  /// How long a file is tried before the course is over without it. 0: for ever.
  std::chrono::milliseconds give_up_after{0};
};

/// The course of a capture, from a skin that describes itself to enough poses. It decides what becomes of a described
/// skin, when a pose counts as captured, which pose comes next, when a device is asked to turn, and when there are
/// enough poses; whoever owns it only shows that.
///
/// A pose counts as captured once it is on disk (PoseKept), or at once where the operator knowingly works without a
/// file. Poses are labelled by the origin cell of the first result of the skin, so that their labels do not depend on
/// how fast results follow. They are numbered by the session, whatever number the recorder gave them; one that is
/// recaptured keeps its number, by which the operator knows it, and is not said to repeat the pose that it replaces.
/// Only where that pose still waits for the file it gets a number of its own, so that the file's answers can be told
/// apart.
///
/// A device that turns itself (setRobot()) is asked to as soon as the last pose is on disk, the result is that of the
/// session as it is, and the advice for it is there. It is not asked before the first pose, which is taken where the
/// part lies.
///
/// It has no thread, waits for nothing and belongs to the thread of its owner. An owner with an event loop calls its
/// functions when something happened; one with a loop of its own does so from there and calls tick() meanwhile.
class CaptureWorkflow {
 public:
  using Clock = std::chrono::steady_clock;  ///< the clock of all times that a course is given
  /// A device that refused so often is not asked any more.
  static constexpr std::size_t kMaxRefusals = 10;
  /// A device that turns itself is stopped after so many poses, whatever the assessment still hopes for: a result that
  /// is not good by then does not lack poses.
  static constexpr std::size_t kMaxPosesByItself = 12;

  /// `owner` must outlive the course.
  explicit CaptureWorkflow(CaptureOwner& owner, CaptureWorkflowOptions options = {});

  /// The session that a skin begins when it describes itself. `address`: of its source.
  [[nodiscard]] static Session sessionOf(const SkinDescription& skin, const std::string& address);

  /// Begins with a session that was made of this skin. It must live until end().
  void begin(const Session& session, const SkinDescription& skin);
  /// Begins with a session that the skin's poses are added to. Returns false, and nothing begins, if it has other
  /// cells. Other links are taken over (SkinChanged).
  bool join(const Session& session, const SkinDescription& skin);
  /// The skin describes itself again. Other cells or links and another cell model are taken over (SkinChanged).
  void describe(const SkinDescription& skin);
  /// The skin is gone. Poses that are being written still become captured.
  void end();
  /// Another session is opened, or none: nothing of the last one is told any more.
  void forget();
  [[nodiscard]] bool isOn() const { return session_ != nullptr; }  ///< a skin is connected, and a session begun

  /// Adds a pose that was recorded to the session, or puts it in the place of the one that is recaptured. Ignored if no
  /// more are wanted.
  void take(const CapturedPose& captured);
  /// The file's answer about a pose.
  void setStored(PoseId pose, const StoreOutcome& outcome, Clock::time_point now = Clock::now());
  /// Memory: what waits for a file counts as captured now, and what comes at once.
  void setKeptIn(KeptIn where);
  /// How many poses are being written.
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }
  /// The file could not be written the last time.
  [[nodiscard]] bool isFileRefused() const { return refused_since_.has_value(); }
  /// Tries a file again, or gives up, as the options say.
  void tick(Clock::time_point now = Clock::now());

  /// The newest result; null: none. `is_current`: no change of the session is still to be solved.
  void setResult(std::shared_ptr<const Reconstruction> result, bool is_current);
  /// The session changed: the result is not current any more.
  void noteChange();

  void setAdvice(const AdviceAnswer& answer);  ///< the answer to AdviceWanted; one to an earlier question is dropped
  /// The pose that would help most; none before the first result, or without a skin.
  [[nodiscard]] const std::optional<PoseAdvice>& nextPose() const { return next_pose_; }
  /// Following that advice would help: not for the first pose, which may be any, nor where there are enough.
  [[nodiscard]] bool isNextPoseWanted() const { return next_pose_ && next_pose_wanted_; }
  /// The part can't be brought to the next pose: another one is advised.
  void skipPose();

  /// The next capture takes the place of this pose. A device that turns itself is asked to turn there.
  void recapture(PoseId pose);
  void cancelRecapture() { recapturing_.reset(); }  ///< the next capture is a new pose again
  /// The pose whose place the next capture takes.
  [[nodiscard]] std::optional<PoseId> recapturing() const { return recapturing_; }

  /// The device can be asked to turn itself.
  [[nodiscard]] bool canTurn() const { return isOn() && can_turn_; }
  /// The device turns itself from pose to pose until the session has `poses`, or with 0 until there are enough, as the
  /// options or the assessment say. Ignored if it can't.
  void setRobot(bool on, std::size_t poses = 0);
  [[nodiscard]] bool isRobotOn() const { return robot_; }  ///< the device turns itself from pose to pose
  /// Asks the device to turn to the next pose. While the advice of the latest pose is still to come, as soon as it
  /// does.
  void turnToNextPose();
  /// Asks the device to turn until `up_o` (frame of the largest patch) points up, and ends the robot's run.
  void turnTo(const Eigen::Vector3d& up_o);
  /// The device's answer.
  void setOutcome(const CommandOutcome& outcome);
  /// Whether the device sends. One that does not is asked for nothing, and what it leaves undone is no refusal; once it
  /// sends again, the robot's run goes on.
  void setSending(bool sends);

  /// Another pose would help, as the result's assessment says; or the number that the robot was given, or that the
  /// options ask for, is not reached yet.
  [[nodiscard]] bool wantsMorePoses() const;
  /// The robot, or the number of poses in the options, came to its end, and all poses are on disk; or the file was
  /// given up.
  [[nodiscard]] bool isFinished() const { return finished_; }

 private:
  void keep(std::map<PoseId, CapturedPose>::iterator waiting, KeptIn where, const Message& without_raw);
  void replaceSkin(const SkinDescription& skin, const SkinChanged& changed);
  [[nodiscard]] std::shared_ptr<const PoseCapture> named(const std::shared_ptr<const PoseCapture>& pose,
                                                         PoseId id) const;
  [[nodiscard]] std::optional<std::size_t> indexOf(PoseId pose) const;
  /// The number of poses that somebody asked for; 0: nobody did, and the assessment says when there are enough.
  [[nodiscard]] std::size_t numberAskedFor() const;
  void askForAdvice();
  void sendTurn(const Eigen::Vector3d& up_o);
  /// There are poses, all are on disk, and the result is that of the session as it is.
  [[nodiscard]] bool isSettled() const;
  void finishIfEnough();
  /// The robot's next turn.
  void turnIfTime();

  CaptureOwner& owner_;
  CaptureWorkflowOptions options_;

  const Session* session_ = nullptr;
  bool can_turn_ = false;
  bool finished_ = false;
  std::shared_ptr<const Reconstruction> labels_from_;  ///< the first result of the skin
  std::shared_ptr<const Reconstruction> result_;
  bool is_current_ = false;

  KeptIn kept_in_ = KeptIn::File;
  std::map<PoseId, CapturedPose> waiting_;  ///< for the file
  std::optional<Clock::time_point> refused_since_;
  Clock::time_point next_try_{};

  std::optional<PoseId> recapturing_;
  std::optional<PoseAdvice> next_pose_;
  bool next_pose_wanted_ = false;
  std::uint64_t advice_asked_ = 0;     ///< answers to earlier questions are dropped
  std::uint64_t advice_answered_ = 0;  ///< the question that next_pose_ is from
  bool turns_when_advised_ = false;
  std::vector<Eigen::Vector3d> unreachable_;
  bool robot_ = false;
  bool is_sending_ = true;
  std::size_t robot_poses_ = 0;   ///< the number that the robot was given; 0: none
  std::uint32_t asked_turn_ = 0;  ///< the command whose refusal counts; 0: none
  Eigen::Vector3d asked_up_ = Eigen::Vector3d::Zero();
  std::size_t refusals_ = 0;
};

}  // namespace hexoderm
