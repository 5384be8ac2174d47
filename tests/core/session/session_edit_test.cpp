#include "hexoderm/session/session_edit.h"

#include "hexoderm/util/error.h"
#include "tests/core/session/session_edits.h"
#include "tests/support/session_matchers.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

namespace hexoderm {
namespace {

using test::edits;
using test::kA;
using test::namedPose;
using test::threePoses;

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
