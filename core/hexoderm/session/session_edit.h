#pragma once

#include "hexoderm/device/sample_frame.h"
#include "hexoderm/session/session.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hexoderm {

/// Session::addPose() of a new capture. A store throws InvalidArgument if it holds numbers that are not finite, or
/// negative variances.
struct AddPose {
  SessionPose pose;
  std::optional<std::size_t> index{};                     ///< among the poses then; absent: at the end
  std::shared_ptr<const std::vector<SampleFrame>> raw{};  ///< the frames it was averaged from; null: not kept
};
/// Session::removePose(). The capture stays in the file and can be restored.
struct RemovePose {
  std::size_t index = 0;
};
/// The reverse of a removal: the pose is as it was before, at place `index`. In a file, the last removed pose with this
/// ID and these readings is meant; a file that was made after the removal knows nothing of it and takes the pose as a
/// capture.
struct RestorePose {
  SessionPose pose;  ///< the pose before its removal
  std::size_t index = 0;
};
/// Session::setPoseDisabled().
struct SetPoseDisabled {
  std::size_t index = 0;
  bool disabled = true;
  std::string why{};
};
/// Session::setJointAngles(): those read from a file, typed, or sent by the device.
struct SetJointAngles {
  std::size_t index = 0;
  JointAngles angles{};
};
/// Session::setLinkMuted().
struct SetLinkMuted {
  LinkEnd a;
  LinkEnd b;
  bool muted = true;
  std::string why{};
};
/// Session::setRobot(): whose description was chosen.
struct SetRobot {
  std::optional<RobotDescription> robot{};
};
/// Session::setPlacement(): what is decided about the place of a patch on the robot.
struct SetPatchPlacement {
  PatchPlacement placement{};
};
/// Session::setSide(): on the outside of a body or in a hollow.
struct SetSkinSide {
  SkinSide side = SkinSide::Unknown;
};
/// Session::setSkin(): cell model and topology as reported anew. Poses, and links that were set aside, stay.
struct SetSkin {
  std::shared_ptr<const CellModel> model;  ///< never null
  NeighborList neighbors;
};

/// One edit of a session, as a value: it is applied to sessions, kept for undo and written to files.
using SessionEdit = std::variant<AddPose, RemovePose, RestorePose, SetPoseDisabled, SetJointAngles, SetLinkMuted,
                                 SetRobot, SetPatchPlacement, SetSkinSide, SetSkin>;

/// Whether the edit is about the robot alone, with its joint angles: what was reconstructed of the skin stays as it is.
bool isAboutRobot(const SessionEdit& edit);

/// Changes the session. Throws InvalidArgument if the edit makes no sense for it (no such pose, no capture, a link with
/// two equal ends, no cell model); the session then is as before.
void apply(const SessionEdit& edit, Session& session);

/// The edit that takes `edit` back: apply(edit, s) and then apply(inverse(edit, before), s) leaves `before`, except for
/// its revision and the IDs that are not used again. Throws InvalidArgument if the edit makes no sense for `before`.
/// The inverse of the inverse of AddPose is RestorePose, because the capture is known by then.
SessionEdit inverse(const SessionEdit& edit, const Session& before);

}  // namespace hexoderm
