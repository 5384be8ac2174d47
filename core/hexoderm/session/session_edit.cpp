#include "hexoderm/session/session_edit.h"

#include "hexoderm/base/error.h"

namespace hexoderm {
namespace {

const SessionPose& poseAt(const Session& session, std::size_t index) {
  if (index >= session.poses().size()) throw InvalidArgument(message("there is no pose at place {}", index));
  return session.poses()[index];
}

struct Apply {
  Session& session;

  void operator()(const AddPose& add) const { session.addPose(add.pose, add.index); }
  void operator()(const RemovePose& remove) const { session.removePose(remove.index); }
  void operator()(const RestorePose& restore) const { session.addPose(restore.pose, restore.index); }
  void operator()(const SetPoseDisabled& set) const { session.setPoseDisabled(set.index, set.disabled, set.why); }
  void operator()(const SetJointAngles& set) const { session.setJointAngles(set.index, set.angles); }
  void operator()(const SetLinkMuted& set) const { session.setLinkMuted(set.a, set.b, set.muted, set.why); }
  void operator()(const SetRobot& set) const { session.setRobot(set.robot); }
  void operator()(const SetPatchPlacement& set) const { session.setPlacement(set.placement); }
  void operator()(const SetSkinSide& set) const { session.setSide(set.side); }
  void operator()(const SetSkin& skin) const {
    if (!skin.model) throw InvalidArgument(message("a skin must have a cell model"));
    session.setSkin(*skin.model, skin.neighbors);
  }
};

struct Invert {
  const Session& before;

  SessionEdit operator()(const AddPose& add) const { return RemovePose{add.index.value_or(before.poses().size())}; }
  SessionEdit operator()(const RemovePose& remove) const {
    return RestorePose{poseAt(before, remove.index), remove.index};
  }
  SessionEdit operator()(const RestorePose& restore) const { return RemovePose{restore.index}; }
  SessionEdit operator()(const SetPoseDisabled& set) const {
    const SessionPose& pose = poseAt(before, set.index);
    return SetPoseDisabled{set.index, pose.disabled, pose.why_disabled};
  }
  SessionEdit operator()(const SetJointAngles& set) const {
    return SetJointAngles{set.index, poseAt(before, set.index).joint_angles};
  }
  SessionEdit operator()(const SetLinkMuted& set) const {
    const MutedLink* link = before.findMutedLink(set.a, set.b);
    return SetLinkMuted{set.a, set.b, link != nullptr, link != nullptr ? link->why : std::string()};
  }
  SessionEdit operator()(const SetRobot& /*set*/) const { return SetRobot{before.robot()}; }
  SessionEdit operator()(const SetPatchPlacement& set) const {
    if (const PatchPlacement* placement = before.findPlacement(set.placement.origin)) {
      return SetPatchPlacement{*placement};
    }
    PatchPlacement nothing;
    nothing.origin = set.placement.origin;
    return SetPatchPlacement{nothing};
  }
  SessionEdit operator()(const SetSkinSide& /*set*/) const { return SetSkinSide{before.side()}; }
  SessionEdit operator()(const SetSkin& /*skin*/) const {
    return SetSkin{std::make_shared<const CellModel>(before.model()), before.neighbors()};
  }
};

}  // namespace

bool isAboutRobot(const SessionEdit& edit) {
  return std::holds_alternative<SetRobot>(edit) || std::holds_alternative<SetPatchPlacement>(edit) ||
         std::holds_alternative<SetJointAngles>(edit);
}

void apply(const SessionEdit& edit, Session& session) { std::visit(Apply{session}, edit); }

SessionEdit inverse(const SessionEdit& edit, const Session& before) { return std::visit(Invert{before}, edit); }

}  // namespace hexoderm
