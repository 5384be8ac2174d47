#include "hexoderm/capture/capture_workflow.h"

#include "hexoderm/solve/metrics/pose_coverage.h"

#include <algorithm>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

std::set<CellId> cellsOf(const NeighborList& neighbors) {
  std::set<CellId> cells;
  for (const CellReport& cell : neighbors) cells.insert(cell.id);
  return cells;
}

}  // namespace

AdviceAnswer adviseOn(const AdviceQuestion& question) {
  AdviceAnswer answer;
  answer.number = question.number;
  answer.advice = adviseNextPose(*question.seen->model, directionsSeen(*question.seen), question.unreachable);
  const std::optional<NextPose> next = describeNextPose(answer.advice, *question.seen);
  answer.is_wanted = next && next->isWanted();
  return answer;
}

CaptureWorkflow::CaptureWorkflow(CaptureOwner& owner, CaptureWorkflowOptions options)
    : owner_(owner), options_(options) {}

Session CaptureWorkflow::sessionOf(const SkinDescription& skin, const std::string& address) {
  Session session(*skin.model, skin.neighbors,
                  SourceDescription{inRow({skin.device, Message::verbatim(address)}, ", "), "", ""});
  if (skin.truth) session.setTruth(*skin.truth);
  return session;
}

void CaptureWorkflow::begin(const Session& session, const SkinDescription& skin) {
  end();
  session_ = &session;
  can_turn_ = skin.can_turn;
}

bool CaptureWorkflow::join(const Session& session, const SkinDescription& skin) {
  if (cellsOf(skin.neighbors) != cellsOf(session.neighbors())) return false;
  begin(session, skin);
  if (skin.neighbors != session.neighbors()) replaceSkin(skin, {true});
  return true;
}

void CaptureWorkflow::describe(const SkinDescription& skin) {
  if (!isOn()) return;
  can_turn_ = skin.can_turn;
  const bool other_model = cellModelToJson(*skin.model) != cellModelToJson(session_->model());
  if (other_model || skin.neighbors != session_->neighbors()) replaceSkin(skin, {false, other_model});
}

void CaptureWorkflow::replaceSkin(const SkinDescription& skin, const SkinChanged& changed) {
  labels_from_.reset();
  owner_.perform({SetSkin{skin.model, skin.neighbors}});
  owner_.onWorkflowEvent(changed);
}

void CaptureWorkflow::end() {
  session_ = nullptr;
  can_turn_ = false;
  finished_ = false;
  labels_from_.reset();
  result_.reset();
  is_current_ = false;
  recapturing_.reset();
  unreachable_.clear();
  turns_when_advised_ = false;
  robot_ = false;
  is_sending_ = true;
  asked_turn_ = 0;
  refusals_ = 0;
  askForAdvice();
}

void CaptureWorkflow::forget() {
  end();
  waiting_.clear();
  refused_since_.reset();
  kept_in_ = KeptIn::File;
}

std::shared_ptr<const PoseCapture> CaptureWorkflow::named(const std::shared_ptr<const PoseCapture>& pose,
                                                          PoseId id) const {
  auto with_name = std::make_shared<PoseCapture>(*pose);
  with_name->id = id;
  if (with_name->label.empty() && labels_from_) with_name->label = poseLabel(*labels_from_, *pose);
  return with_name;
}

std::optional<std::size_t> CaptureWorkflow::indexOf(PoseId pose) const {
  const std::vector<SessionPose>& poses = session_->poses();
  const auto found = std::ranges::find_if(poses, [&](const SessionPose& other) { return other.capture->id == pose; });
  if (found == poses.end()) return std::nullopt;
  return static_cast<std::size_t>(found - poses.begin());
}

void CaptureWorkflow::take(const CapturedPose& captured) {
  if (!isOn()) return;
  const std::optional<std::size_t> replaced = recapturing_ ? indexOf(*recapturing_) : std::nullopt;
  if (!replaced && options_.poses > 0 && session_->poses().size() >= options_.poses) return;
  const bool keeps_number = replaced && !waiting_.contains(*recapturing_);
  const PoseId id = keeps_number ? *recapturing_ : session_->nextPoseId();
  PoseTaken taken{captured, {}};
  taken.captured.pose = named(captured.pose, id);
  AddPose add{{taken.captured.pose, false, {}, taken.captured.joint_angles}};
  if (options_.keep_raw) add.raw = std::make_shared<const std::vector<SampleFrame>>(std::move(taken.captured.frames));
  taken.captured.frames.clear();
  std::vector<SessionEdit> edits;
  if (replaced) {
    taken.replaced = std::exchange(recapturing_, std::nullopt);
    if (taken.captured.repeats == taken.replaced) taken.captured.repeats.reset();
    edits.emplace_back(RemovePose{*replaced});
    add.index = replaced;
  }
  edits.emplace_back(std::move(add));
  waiting_.insert_or_assign(id, taken.captured);
  owner_.perform(edits);
  owner_.onWorkflowEvent(taken);
  if (kept_in_ != KeptIn::Memory) return;
  // The receiver may have ended the course, or saved the session.
  if (const auto waiting = waiting_.find(id); waiting != waiting_.end()) keep(waiting, KeptIn::Memory, {});
}

void CaptureWorkflow::keep(std::map<PoseId, CapturedPose>::iterator waiting, KeptIn where, const Message& without_raw) {
  const CapturedPose captured = std::move(waiting->second);
  waiting_.erase(waiting);
  owner_.onWorkflowEvent(PoseKept{captured, where, without_raw});
  finishIfEnough();
  turnIfTime();
}

void CaptureWorkflow::setStored(PoseId pose, const StoreOutcome& outcome, Clock::time_point now) {
  const auto waiting = waiting_.find(pose);
  if (waiting == waiting_.end()) return;
  if (outcome.is_kept) {
    if (refused_since_) return;
    refused_since_ = now;
    next_try_ = now + options_.retry_every;
    owner_.onWorkflowEvent(FileRefused{outcome.error});
  } else if (outcome.error.empty()) {
    refused_since_.reset();
    if (!outcome.renewed.empty()) owner_.onWorkflowEvent(FileRenewed{outcome.renewed});
    keep(waiting, KeptIn::File, outcome.without_raw);
  } else {
    waiting_.erase(waiting);
    owner_.onWorkflowEvent(PoseLost{pose, outcome.error});
  }
}

void CaptureWorkflow::setKeptIn(KeptIn where) {
  kept_in_ = where;
  refused_since_.reset();
  while (kept_in_ == KeptIn::Memory && !waiting_.empty()) keep(waiting_.begin(), KeptIn::Memory, {});
}

void CaptureWorkflow::tick(Clock::time_point now) {
  using std::chrono::milliseconds;
  if (!refused_since_ || finished_) return;
  if (options_.give_up_after > milliseconds(0) && now - *refused_since_ >= options_.give_up_after) {
    finished_ = true;
    owner_.onWorkflowEvent(WorkflowFinished{});
  } else if (options_.retry_every > milliseconds(0) && now >= next_try_) {
    next_try_ = now + options_.retry_every;
    owner_.retryWriting();
  }
}

void CaptureWorkflow::setResult(std::shared_ptr<const Reconstruction> result, bool is_current) {
  result_ = std::move(result);
  is_current_ = result_ && is_current;
  if (!isOn()) return;
  if (!labels_from_) labels_from_ = result_;
  finishIfEnough();
  askForAdvice();
}

void CaptureWorkflow::noteChange() {
  is_current_ = false;
  if (recapturing_ && !(isOn() && indexOf(*recapturing_))) recapturing_.reset();
}

void CaptureWorkflow::askForAdvice() {
  ++advice_asked_;
  if (isOn() && result_ && largestPatch(*result_) != nullptr) {
    owner_.onWorkflowEvent(AdviceWanted{{advice_asked_, result_, unreachable_}});
  } else if (std::exchange(next_pose_, std::nullopt)) {
    owner_.onWorkflowEvent(AdviceChanged{});
  }
}

void CaptureWorkflow::setAdvice(const AdviceAnswer& answer) {
  if (answer.number != advice_asked_) return;
  next_pose_ = answer.advice;
  next_pose_wanted_ = answer.is_wanted;
  advice_answered_ = answer.number;
  owner_.onWorkflowEvent(AdviceChanged{});
  if (turns_when_advised_) {
    turnToNextPose();
  } else {
    turnIfTime();
  }
}

void CaptureWorkflow::skipPose() {
  if (!next_pose_) return;
  unreachable_.push_back(next_pose_->up);
  askForAdvice();
}

void CaptureWorkflow::recapture(PoseId pose) {
  if (!isOn() || !indexOf(pose)) return;
  recapturing_ = pose;
  const PatchReconstruction* patch = canTurn() && result_ ? largestPatch(*result_) : nullptr;
  if (patch == nullptr) return;
  const auto gravity = std::ranges::find(patch->gravity, pose, &GravityDirection::pose);
  if (gravity != patch->gravity.end()) sendTurn(gravity->g_o);
}

void CaptureWorkflow::sendTurn(const Eigen::Vector3d& up_o) {
  turns_when_advised_ = false;
  asked_up_ = up_o;
  asked_turn_ = owner_.send(TurnTo{largestPatch(*result_)->origin, up_o});
}

void CaptureWorkflow::turnToNextPose() {
  if (!canTurn() || !next_pose_) return;
  turns_when_advised_ = !is_current_ || advice_answered_ != advice_asked_;
  if (!turns_when_advised_) sendTurn(next_pose_->up);
}

void CaptureWorkflow::turnTo(const Eigen::Vector3d& up_o) {
  if (!canTurn() || !result_ || largestPatch(*result_) == nullptr) return;
  robot_ = false;
  turns_when_advised_ = false;
  // A refusal of what somebody asked for by hand says nothing about where the robot can turn.
  asked_turn_ = 0;
  owner_.send(TurnTo{largestPatch(*result_)->origin, up_o.normalized()});
}

void CaptureWorkflow::setOutcome(const CommandOutcome& outcome) {
  if (asked_turn_ == 0 || outcome.command != asked_turn_) return;
  asked_turn_ = 0;
  if (outcome.done || !is_sending_) return;
  unreachable_.push_back(asked_up_);
  const bool gives_up = ++refusals_ > kMaxRefusals;
  if (gives_up) robot_ = false;
  owner_.onWorkflowEvent(TurnRefused{outcome.message, refusals_, gives_up});
  askForAdvice();
}

void CaptureWorkflow::setSending(bool sends) {
  if (std::exchange(is_sending_, sends) == sends || !sends) return;
  turnIfTime();
}

void CaptureWorkflow::setRobot(bool on, std::size_t poses) {
  robot_ = on && canTurn();
  robot_poses_ = poses;
  refusals_ = 0;
  finished_ = false;
  finishIfEnough();
  turnIfTime();
}

std::size_t CaptureWorkflow::numberAskedFor() const {
  return robot_ && robot_poses_ > 0 ? robot_poses_ : options_.poses;
}

bool CaptureWorkflow::wantsMorePoses() const {
  if (!isOn()) return false;
  if (const std::size_t poses = numberAskedFor(); poses > 0) return session_->poses().size() < poses;
  return !result_ || result_->assessment.wantsPose();
}

bool CaptureWorkflow::isSettled() const {
  return isOn() && !finished_ && is_current_ && waiting_.empty() && !session_->poses().empty();
}

void CaptureWorkflow::finishIfEnough() {
  const bool has_end = robot_ || options_.poses > 0;
  if (!has_end || !isSettled()) return;
  const bool is_too_much = robot_ && numberAskedFor() == 0 && session_->poses().size() >= kMaxPosesByItself;
  if (wantsMorePoses() && !is_too_much) return;
  robot_ = false;
  finished_ = true;
  owner_.onWorkflowEvent(WorkflowFinished{});
}

void CaptureWorkflow::turnIfTime() {
  if (robot_ && is_sending_ && isSettled() && advice_answered_ == advice_asked_) turnToNextPose();
}

}  // namespace hexoderm
