#include "hexoderm/session/session_joint_angles.h"

#include "hexoderm/session/simulated_session.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

SimulatedRobot demoRobot() {
  SimulatedRobotOptions options;
  options.mounts = demoMounts();
  return {builtInCellModel("hex-bma150"), RobotModel::read(HEXODERM_DEMO_ROBOT), options};
}

TEST(SessionJointAngles, ASimulatedRobotsSessionHasWhatItReports) {
  SimulatedRobot robot = demoRobot();
  const SimulatedRobotSession simulated = simulateRobotSession(robot, 3, 10);
  ASSERT_EQ(simulated.session.poses().size(), 3U);
  ASSERT_EQ(simulated.poses.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(simulated.session.poses()[k].joint_angles, simulated.poses[k].reported);
    EXPECT_EQ(simulated.session.poses()[k].capture->samples.size(), 34U);
  }
  EXPECT_EQ(simulated.session.truth()->cells.size(), 34U);
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
