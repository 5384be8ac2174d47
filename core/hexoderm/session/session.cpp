#include "hexoderm/session/session.h"

#include "hexoderm/base/error.h"

#include <algorithm>
#include <utility>

namespace hexoderm {
namespace {

/// The key of a muted link.
std::pair<LinkEnd, LinkEnd> endsOf(const MutedLink& link) { return {link.source, link.target}; }

std::shared_ptr<const CellModel> checked(CellModel model) {
  model.validate();
  return std::make_shared<const CellModel>(std::move(model));
}

}  // namespace

Session::Session(CellModel model, NeighborList neighbors, SourceDescription source)
    : model_(checked(std::move(model))),
      neighbors_(std::make_shared<const NeighborList>(std::move(neighbors))),
      source_(std::move(source)) {}

void Session::setSkin(CellModel model, NeighborList neighbors) {
  model_ = checked(std::move(model));
  neighbors_ = std::make_shared<const NeighborList>(std::move(neighbors));
  ++revision_;
}

void Session::setTruth(GroundTruth truth) {
  truth_ = std::make_shared<const GroundTruth>(std::move(truth));
  ++revision_;
}

void Session::setSource(SourceDescription source) {
  source_ = std::move(source);
  ++revision_;
}

PoseId Session::nextPoseId() const { return PoseId(largest_pose_id_ + 1); }

void Session::addPose(SessionPose pose, std::optional<std::size_t> index) {
  if (!pose.capture) throw InvalidArgument(message("a pose must hold a capture"));
  const std::size_t at = index.value_or(poses_.size());
  if (at > poses_.size()) throw InvalidArgument(message("there is no place {} among the poses", at));
  pose.joint_angles.validate();
  largest_pose_id_ = std::max(largest_pose_id_, pose.capture->id.value());
  poses_.insert(poses_.begin() + static_cast<std::ptrdiff_t>(at), std::move(pose));
  ++revision_;
}

SessionPose Session::removePose(std::size_t index) {
  if (index >= poses_.size()) throw InvalidArgument(message("there is no pose at place {}", index));
  SessionPose pose = std::move(poses_[index]);
  poses_.erase(poses_.begin() + static_cast<std::ptrdiff_t>(index));
  ++revision_;
  return pose;
}

void Session::setPoseDisabled(std::size_t index, bool disabled, std::string why) {
  if (index >= poses_.size()) throw InvalidArgument(message("there is no pose at place {}", index));
  poses_[index].disabled = disabled;
  poses_[index].why_disabled = disabled ? std::move(why) : std::string();
  ++revision_;
}

void Session::setJointAngles(std::size_t index, JointAngles angles) {
  if (index >= poses_.size()) throw InvalidArgument(message("there is no pose at place {}", index));
  angles.validate();
  poses_[index].joint_angles = std::move(angles);
  ++revision_;
}

const MutedLink* Session::findMutedLink(LinkEnd a, LinkEnd b) const {
  const auto found = std::ranges::lower_bound(muted_links_, std::pair(std::min(a, b), std::max(a, b)), {}, endsOf);
  const bool there = found != muted_links_.end() && endsOf(*found) == std::pair(std::min(a, b), std::max(a, b));
  return there ? &*found : nullptr;
}

void Session::setLinkMuted(LinkEnd a, LinkEnd b, bool muted, std::string why) {
  if (a == b) {
    throw InvalidArgument(message("a link joins two ports, and both ends are port {} of cell {}", a.port, a.cell));
  }
  const std::pair ends(std::min(a, b), std::max(a, b));
  auto place = std::ranges::lower_bound(muted_links_, ends, {}, endsOf);
  if (place != muted_links_.end() && endsOf(*place) == ends) place = muted_links_.erase(place);
  if (muted) muted_links_.insert(place, {ends.first, ends.second, std::move(why)});
  ++revision_;
}

const PatchPlacement* Session::findPlacement(CellId origin) const {
  const auto found = std::ranges::lower_bound(placements_, origin, {}, &PatchPlacement::origin);
  return found != placements_.end() && found->origin == origin ? &*found : nullptr;
}

void Session::setRobot(std::optional<RobotDescription> robot) {
  if (robot) robot->validate();
  robot_ = std::move(robot);
  ++revision_;
}

void Session::setPlacement(PatchPlacement placement) {
  placement.validate();
  auto place = std::ranges::lower_bound(placements_, placement.origin, {}, &PatchPlacement::origin);
  if (place != placements_.end() && place->origin == placement.origin) place = placements_.erase(place);
  if (!placement.isEmpty()) placements_.insert(place, std::move(placement));
  ++revision_;
}

std::shared_ptr<const SessionSnapshot> Session::snapshot() const {
  return std::make_shared<const SessionSnapshot>(
      SessionSnapshot{revision_, model_, neighbors_, poses_, source_, truth_, muted_links_, robot_, placements_});
}

}  // namespace hexoderm
