#include "hexoderm/session/session_edit.h"

#include "tests/core/session/session_edits.h"

namespace hexoderm {
namespace {

using test::edits;
using test::namedPose;
using test::threePoses;

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
                session.neighbors() == before.neighbors() && session.side() == before.side();
    for (std::size_t k = 0; same && k < session.poses().size(); ++k) {
      const SessionPose& a = session.poses()[k];
      const SessionPose& b = before.poses()[k];
      same = a.capture->id == b.capture->id && a.disabled == b.disabled && a.why_disabled == b.why_disabled;
    }
    EXPECT_EQ(isAboutRobot(edit), same);
  }
}

TEST(SessionEdit, OneThatMakesNoSenseIsRefusedAndChangesNothing) {
  for (const SessionEdit& edit : test::editsThatMakeNoSense()) {
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
