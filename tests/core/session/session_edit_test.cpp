#include "hexoderm/session/session_edit.h"

#include "hexoderm/util/error.h"
#include "tests/support/session_matchers.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

namespace hexoderm {
namespace {

SessionPose namedPose(std::uint32_t id) {
  return {std::make_shared<const PoseCapture>(PoseCapture{PoseId(id), message("pose {}", id), {}}), false};
}

const LinkEnd kA{CellId(1), PortNumber(2)};
const LinkEnd kB{CellId(2), PortNumber(3)};

Session threePoses() {
  Session session(builtInCellModel("hex-bma150"), {{CellId(1), "", {}}, {CellId(2), "", {}}});
  for (std::uint32_t id : {4U, 5U, 6U}) session.addPose(namedPose(id));
  session.setPoseDisabled(1, true, "someone leaned on the arm");
  session.setJointAngles(2, {{{"elbow", 1.5}}});
  session.setLinkMuted(kA, kB, true, "a cable");
  session.setRobot(RobotDescription{"arm.urdf", "00", {}});
  session.setPlacement(test::placementWithEverything(CellId(1)));
  return session;
}

PatchPlacement emptyPlacement(CellId origin) {
  PatchPlacement placement;
  placement.origin = origin;
  return placement;
}

PatchPlacement onLink(CellId origin, const char* link) {
  PatchPlacement placement = emptyPlacement(origin);
  placement.link = link;
  return placement;
}

std::vector<SessionEdit> edits() {
  CellModel model = builtInCellModel("hex-bma150");
  model.name = "another";
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
          SetSkin{std::make_shared<const CellModel>(model), {{CellId(1), "elbow", {}}}}};
}

PatchPlacement spoiled(const std::function<void(PatchPlacement&)>& spoil) {
  PatchPlacement placement = test::placementWithEverything(CellId(1));
  spoil(placement);
  return placement;
}

TEST(SessionEdit, ItsInverseTakesItBackAndTheInverseOfThatDoesItAgain) {
  for (const SessionEdit& edit : edits()) {
    SCOPED_TRACE(edit.index());
    const Session before = threePoses();
    Session session = before;
    const SessionEdit back = inverse(edit, session);
    apply(edit, session);
    const Session after = session;
    EXPECT_GT(after.revision(), before.revision());
    const SessionEdit again = inverse(back, session);
    apply(back, session);
    test::expectSameSession(session, before);
    apply(again, session);
    test::expectSameSession(session, after);
  }
}

TEST(SessionEdit, ACaptureThatComesBackIsRestored) {
  Session session = threePoses();
  const SessionEdit back = inverse(AddPose{namedPose(9)}, session);
  apply(AddPose{namedPose(9)}, session);
  const SessionEdit again = inverse(back, session);
  const auto* restore = std::get_if<RestorePose>(&again);
  ASSERT_NE(restore, nullptr) << "a file has the capture already";
  EXPECT_EQ(restore->pose.capture, session.poses()[3].capture);
  EXPECT_EQ(restore->index, 3U);
}

TEST(SessionEdit, OnlyThoseAboutTheRobotLeaveTheSkinAsItIs) {
  for (const SessionEdit& edit : edits()) {
    SCOPED_TRACE(edit.index());
    Session session = threePoses();
    apply(edit, session);
    // What a solver looks at.
    const Session before = threePoses();
    bool same = session.poses().size() == before.poses().size() && session.mutedLinks() == before.mutedLinks() &&
                session.neighbors() == before.neighbors();
    for (std::size_t k = 0; same && k < session.poses().size(); ++k) {
      const SessionPose& a = session.poses()[k];
      const SessionPose& b = before.poses()[k];
      same = a.capture->id == b.capture->id && a.disabled == b.disabled && a.why_disabled == b.why_disabled;
    }
    EXPECT_EQ(isAboutRobot(edit), same);
  }
}

TEST(SessionEdit, OneThatMakesNoSenseIsRefusedAndChangesNothing) {
  const std::vector<SessionEdit> bad = {AddPose{namedPose(9), 4},
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
  for (const SessionEdit& edit : bad) {
    SCOPED_TRACE(edit.index());
    Session session = threePoses();
    EXPECT_THROW(apply(edit, session), InvalidArgument);
    test::expectSameSession(session, threePoses());
  }
  EXPECT_THROW(static_cast<void>(inverse(RemovePose{3}, threePoses())), InvalidArgument);
  EXPECT_THROW(static_cast<void>(inverse(SetPoseDisabled{3}, threePoses())), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
