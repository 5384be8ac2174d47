#pragma once

#include "hexoderm/session/session_edit.h"
#include "tests/support/options.h"
#include "tests/support/session_matchers.h"
#include "tests/support/testing.h"

namespace hexoderm::test {

inline SessionPose namedPose(std::uint32_t id) {
  return {std::make_shared<const PoseCapture>(PoseCapture{PoseId(id), message("pose {}", id), {}}), false};
}

inline const LinkEnd kA{CellId(1), PortNumber(2)};
inline const LinkEnd kB{CellId(2), PortNumber(3)};

/// Three poses, with something of everything that edits change.
inline Session threePoses() {
  Session session(builtInCellModel("hex-bma150"), {{CellId(1), "", {}}, {CellId(2), "", {}}});
  for (std::uint32_t id : {4U, 5U, 6U}) session.addPose(namedPose(id));
  session.setPoseDisabled(1, true, "someone leaned on the arm");
  session.setJointAngles(2, {{{"elbow", 1.5}}});
  session.setLinkMuted(kA, kB, true, "a cable");
  session.setRobot(RobotDescription{"arm.urdf", "00", {}});
  session.setPlacement(placementWithEverything(CellId(1)));
  return session;
}

inline PatchPlacement emptyPlacement(CellId origin) { return with(&PatchPlacement::origin, origin); }

inline PatchPlacement onLink(CellId origin, const char* link) {
  return with(emptyPlacement(origin), &PatchPlacement::link, link);
}

/// Edits of every kind that threePoses() takes.
inline std::vector<SessionEdit> edits() {
  const CellModel model = with(builtInCellModel("hex-bma150"), &CellModel::name, "another");
  return {AddPose{namedPose(9)},
          AddPose{namedPose(9), 1},
          RemovePose{0},
          RemovePose{1},
          RestorePose{namedPose(3), 2},
          SetPoseDisabled{0, true, "too warm"},
          SetPoseDisabled{1, false, ""},
          SetPoseDisabled{1, true, "for another reason"},
          SetJointAngles{0, {{{"elbow", 0.1}}}},
          SetJointAngles{2, {{{"elbow", -0.1}, {"wrist", 3}}}},
          SetJointAngles{2, {}},
          SetLinkMuted{kB, kA, false, ""},
          SetLinkMuted{kA, kB, true, "for another reason"},
          SetLinkMuted{kA, {CellId(2), PortNumber(1)}, true, "a joint"},
          SetRobot{RobotDescription{"other.urdf", "11", {{"arm", "/arm"}}}},
          SetRobot{},
          SetPatchPlacement{onLink(CellId(2), "hand")},
          SetPatchPlacement{onLink(CellId(1), "hand")},
          SetPatchPlacement{emptyPlacement(CellId(1))},
          SetPatchPlacement{emptyPlacement(CellId(2))},
          SetSkinSide{SkinSide::Concave},
          SetSkin{std::make_shared<const CellModel>(model), {{CellId(1), "elbow", {}}}}};
}

inline PatchPlacement spoiled(const std::function<void(PatchPlacement&)>& spoil) {
  PatchPlacement placement = placementWithEverything(CellId(1));
  spoil(placement);
  return placement;
}

/// Edits that no session of three poses takes.
inline std::vector<SessionEdit> editsThatMakeNoSense() {
  return {AddPose{namedPose(9), 4},
          AddPose{},
          RemovePose{3},
          RestorePose{namedPose(9), 4},
          RestorePose{},
          SetPoseDisabled{3},
          SetLinkMuted{kA, kA},
          SetSkin{nullptr, {}},
          SetJointAngles{3},
          SetJointAngles{0, {{{"elbow", NAN}}}},
          SetJointAngles{0, {{{"", 1}}}},
          SetRobot{RobotDescription{}},
          SetRobot{RobotDescription{"arm.urdf", "", {{"arm", ""}}}},
          SetPatchPlacement{spoiled([](auto& p) { p.points[0].x_l.x() = std::nan(""); })},
          SetPatchPlacement{spoiled([](auto& p) { p.points[0].sigma_m = 0; })},
          SetPatchPlacement{spoiled([](auto& p) { p.distances[0].distance_m = -1; })},
          SetPatchPlacement{spoiled([](auto& p) { p.distances[0].b = CellId(1); })},
          SetPatchPlacement{spoiled([](auto& p) { p.place->link = "other"; })},
          SetPatchPlacement{spoiled([](auto& p) { p.place->origin = CellId(2); })},
          SetPatchPlacement{spoiled([](auto& p) { p.place->T_l_o.R *= 2; })},
          SetPatchPlacement{spoiled([](auto& p) { (*p.place->cov_t_r)(0, 0) = -1; })}};
}

}  // namespace hexoderm::test
