#include "hexoderm/io/session_joint_angles.h"

#include "hexoderm/sim/simulated_session.h"
#include "tests/support/options.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

SimulatedRobot demoRobot() {
  return {builtInCellModel("hex-bma150"), RobotModel::read(HEXODERM_DEMO_ROBOT),
          test::with(&SimulatedRobotOptions::mounts, demoMounts())};
}

TEST(SessionJointAngles, GoThroughACsvFileToAnotherSession) {
  SimulatedRobot robot = demoRobot();
  const Session with = simulateRobotSession(robot, 3, 10).session;
  const JointAnglesTable table = jointAnglesOf(with);
  const std::string csv = jointAnglesCsv(table, robot.robot());

  Session without = with;
  for (std::size_t k = 0; k < 3; ++k) without.setJointAngles(k, {});
  without.removePose(1);
  JointAnglesTable read = parseJointAnglesCsv(csv, "a.csv", robot.robot());
  read.rows.erase(read.rows.begin());
  const JointAnglesForSession found = jointAnglesFor(without, read);
  EXPECT_EQ(found.without_angles, std::vector<PoseId>{PoseId(1)});
  ASSERT_EQ(found.edits.size(), 1U);
  apply(found.edits[0], without);
  EXPECT_EQ(without.poses()[1].joint_angles, with.poses()[2].joint_angles);
}

TEST(SessionJointAngles, ATableOfOtherPosesIsSaidWithWhatBothHave) {
  SimulatedRobot robot = demoRobot();
  const Session session = simulateRobotSession(robot, 3, 10).session;
  JointAnglesTable table{{{PoseId(11), std::nullopt, {}}, {PoseId(14), std::nullopt, {}}}};
  EXPECT_EQ(whyNoPoseHasAngles(session, table).english(),
            "has angles of the poses 11 to 14, but the session has the poses 1 to 3");
  table.rows.push_back({PoseId(2), std::nullopt, {}});
  EXPECT_TRUE(whyNoPoseHasAngles(session, table).empty());

  // Times of another clock. Simulated poses don't say when they were taken.
  const JointAnglesTable timed{{{std::nullopt, 12.5, {}}, {std::nullopt, 13.5, {}}}};
  EXPECT_EQ(whyNoPoseHasAngles(session, timed).english(),
            "has times, but the poses of the session don't say when they were taken: expected a column pose");
  PoseCapture taken = *session.poses()[0].capture;
  taken.taken_at_ms = 1448423000500;
  Session at(session.model(), robot.neighbors());
  at.addPose({std::make_shared<const PoseCapture>(taken)});
  EXPECT_EQ(whyNoPoseHasAngles(at, timed).english(),
            "no time is within a second of a pose: the file goes from 12.5 to 13.5, and the poses were taken from "
            "1448423000.5 to 1448423000.5 (s since 1970, UTC)");
}

TEST(SessionJointAngles, OnlyJointsOfAllPosesMakeATable) {
  SimulatedRobot robot = demoRobot();
  Session session = simulateRobotSession(robot, 3, 10).session;
  session.setJointAngles(0, {});
  session.setJointAngles(1, {{{"elbow", 1}, {"grip", 0}}});
  session.setJointAngles(2, {{{"elbow", 2}, {"wrist_yaw", 0}}});
  const JointAnglesTable table = jointAnglesOf(session);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[1].angles, (JointAngles{{{"elbow", 2}}}));
  EXPECT_NO_THROW(jointAnglesCsv(table, robot.robot()));
}

}  // namespace
}  // namespace hexoderm
