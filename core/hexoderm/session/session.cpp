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
    : now_{1,  checked(std::move(model)), std::make_shared<const NeighborList>(std::move(neighbors)),
           {}, std::move(source),         nullptr,
           {}} {}

void Session::setSkin(CellModel model, NeighborList neighbors) {
  now_.model = checked(std::move(model));
  now_.neighbors = std::make_shared<const NeighborList>(std::move(neighbors));
  ++now_.revision;
}

void Session::setTruth(GroundTruth truth) {
  now_.truth = std::make_shared<const GroundTruth>(std::move(truth));
  ++now_.revision;
}

void Session::setSource(SourceDescription source) {
  now_.source = std::move(source);
  ++now_.revision;
}

PoseId Session::nextPoseId() const { return PoseId(largest_pose_id_ + 1); }

void Session::addPose(SessionPose pose, std::optional<std::size_t> index) {
  if (!pose.capture) throw InvalidArgument(message("a pose must hold a capture"));
  const std::size_t at = index.value_or(now_.poses.size());
  if (at > now_.poses.size()) throw InvalidArgument(message("there is no place {} among the poses", at));
  pose.joint_angles.validate();
  largest_pose_id_ = std::max(largest_pose_id_, pose.capture->id.value());
  now_.poses.insert(now_.poses.begin() + static_cast<std::ptrdiff_t>(at), std::move(pose));
  ++now_.revision;
}

SessionPose Session::removePose(std::size_t index) {
  if (index >= now_.poses.size()) throw InvalidArgument(message("there is no pose at place {}", index));
  SessionPose pose = std::move(now_.poses[index]);
  now_.poses.erase(now_.poses.begin() + static_cast<std::ptrdiff_t>(index));
  ++now_.revision;
  return pose;
}

void Session::setPoseDisabled(std::size_t index, bool disabled, std::string why) {
  if (index >= now_.poses.size()) throw InvalidArgument(message("there is no pose at place {}", index));
  now_.poses[index].disabled = disabled;
  now_.poses[index].why_disabled = disabled ? std::move(why) : std::string();
  ++now_.revision;
}

void Session::setJointAngles(std::size_t index, JointAngles angles) {
  if (index >= now_.poses.size()) throw InvalidArgument(message("there is no pose at place {}", index));
  angles.validate();
  now_.poses[index].joint_angles = std::move(angles);
  ++now_.revision;
}

const MutedLink* Session::findMutedLink(LinkEnd a, LinkEnd b) const {
  const auto found = std::ranges::lower_bound(now_.muted_links, std::pair(std::min(a, b), std::max(a, b)), {}, endsOf);
  const bool there = found != now_.muted_links.end() && endsOf(*found) == std::pair(std::min(a, b), std::max(a, b));
  return there ? &*found : nullptr;
}

void Session::setLinkMuted(LinkEnd a, LinkEnd b, bool muted, std::string why) {
  if (a == b) {
    throw InvalidArgument(message("a link joins two ports, and both ends are port {} of cell {}", a.port, a.cell));
  }
  const std::pair ends(std::min(a, b), std::max(a, b));
  auto place = std::ranges::lower_bound(now_.muted_links, ends, {}, endsOf);
  if (place != now_.muted_links.end() && endsOf(*place) == ends) place = now_.muted_links.erase(place);
  if (muted) now_.muted_links.insert(place, {ends.first, ends.second, std::move(why)});
  ++now_.revision;
}

const PatchPlacement* Session::findPlacement(CellId origin) const {
  const auto found = std::ranges::lower_bound(now_.placements, origin, {}, &PatchPlacement::origin);
  return found != now_.placements.end() && found->origin == origin ? &*found : nullptr;
}

void Session::setRobot(std::optional<RobotDescription> robot) {
  if (robot) robot->validate();
  now_.robot = std::move(robot);
  ++now_.revision;
}

void Session::setSide(SkinSide side) {
  now_.side = side;
  ++now_.revision;
}

void Session::setPlacement(PatchPlacement placement) {
  placement.validate();
  auto place = std::ranges::lower_bound(now_.placements, placement.origin, {}, &PatchPlacement::origin);
  if (place != now_.placements.end() && place->origin == placement.origin) place = now_.placements.erase(place);
  if (!placement.isEmpty()) now_.placements.insert(place, std::move(placement));
  ++now_.revision;
}

std::shared_ptr<const SessionSnapshot> Session::snapshot() const {
  return std::make_shared<const SessionSnapshot>(now_);
}

}  // namespace hexoderm
