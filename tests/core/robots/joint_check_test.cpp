#include "hexoderm/robots/joint_check.h"

#include "tests/support/paths.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const RobotModel& demoArm() {
  static const RobotModel arm = RobotModel::read(HEXODERM_DEMO_ROBOT);
  return arm;
}

JointAngles angles(double pitch, double elbow, double wrist) {
  return {{{"shoulder_pitch", pitch}, {"shoulder_roll", 0}, {"elbow", elbow}, {"wrist_yaw", wrist}, {"grip", 0.01}}};
}

TEST(JointCheck, NamesMissingJoints) {
  EXPECT_TRUE(missingJoints(demoArm(), angles(0, 0, 0)).empty());
  EXPECT_EQ(missingJoints(demoArm(), {{{"elbow", 1}, {"grip", 0}, {"wrist_yaw", 0}}}),
            (std::vector<std::string>{"shoulder_pitch", "shoulder_roll"}));
}

TEST(JointCheck, HasNoDoubtsOfAnglesInsideTheLimits) {
  const std::vector<JointAngles> poses{angles(0, 0, 0), angles(1, 2, -1), angles(-0.8, 2.3, 1.6), angles(2.6, 2.33, 0)};
  EXPECT_TRUE(doubtsOf(demoArm(), poses).empty());
}

TEST(JointCheck, NamesTheWorstPoseOfEachJointBeyondItsLimits) {
  const std::vector<JointAngles> poses{angles(0, 2.5, 0), angles(0, 2.8, 0), angles(0, 1, 0)};
  const JointDoubts doubts = doubtsOf(demoArm(), poses);
  ASSERT_EQ(doubts.beyond_limits.size(), 1U);
  EXPECT_EQ(doubts.beyond_limits[0].joint, "elbow");
  EXPECT_EQ(doubts.beyond_limits[0].index, 1U);
  EXPECT_EQ(doubts.beyond_limits[0].position, 2.8);
  EXPECT_THAT(doubts.beyond_limits[0].message.english(), saysAll("elbow", "160.4°", "131.8°"));
  EXPECT_FALSE(doubts.probably_degrees) << "as degrees it would be inside, but it is not far outside";
}

TEST(JointCheck, ASinglePositionBeyondItsLimitsIsSaid) {
  const RobotJoint& elbow = demoArm().joints()[demoArm().jointNamed("elbow")];
  EXPECT_FALSE(beyondLimits(elbow, elbow.limits->upper + 0.01)) << "calibrations of joints excuse it";
  const auto said = beyondLimits(elbow, 2.8);
  ASSERT_TRUE(said);
  EXPECT_THAT(said->english(), saysAll("elbow", "160.4°", "131.8°"));
  RobotJoint endless = elbow;
  endless.limits.reset();
  EXPECT_FALSE(beyondLimits(endless, 100));
}

TEST(JointCheck, NoticesDegreesThatWereReadAsRadians) {
  const std::vector<JointAngles> poses{angles(30, 90, 0), angles(-20, 45, 80)};
  const JointDoubts doubts = doubtsOf(demoArm(), poses);
  ASSERT_TRUE(doubts.probably_degrees);
  EXPECT_THAT(doubts.probably_degrees->english(), saysAll("degrees", "3 of 3 joints", "shoulder_pitch"));
}

TEST(JointCheck, WrongAnglesThatAreNoDegreesEitherAreNotCalledSo) {
  const std::vector<JointAngles> poses{angles(5000, 9000, 4000)};
  const JointDoubts doubts = doubtsOf(demoArm(), poses);
  EXPECT_FALSE(doubts.probably_degrees);
  EXPECT_EQ(doubts.beyond_limits.size(), 3U);
}

}  // namespace
}  // namespace hexoderm
