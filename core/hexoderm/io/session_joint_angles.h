#pragma once

#include "hexoderm/base/message.h"
#include "hexoderm/robots/joint_angles_csv.h"
#include "hexoderm/session/session_edit.h"

#include <vector>

namespace hexoderm {

/// What a table of joint angles says about a session's poses.
struct JointAnglesForSession {
  std::vector<SetJointAngles> edits;   ///< for each pose that the table has, in the session's order
  std::vector<PoseId> without_angles;  ///< poses of the session that it does not have, disabled ones too
};
/// The rows of a table, by the poses that they belong to.
JointAnglesForSession jointAnglesFor(const Session& session, const JointAnglesTable& table);
/// Why a table has nothing for any pose of a session, with the numbers or times of both; empty where it has something.
Message whyNoPoseHasAngles(const Session& session, const JointAnglesTable& table);

/// The angles that the session's poses have, by pose; poses without any are left out. Joints that not every such pose
/// names are left out too.
JointAnglesTable jointAnglesOf(const Session& session);

}  // namespace hexoderm
