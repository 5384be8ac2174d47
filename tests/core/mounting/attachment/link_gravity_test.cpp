#include "hexoderm/mounting/attachment/link_gravity.h"

#include "tests/core/mounting/attachment/drawn_links.h"

namespace hexoderm {
namespace {

/// How gravity on a link changes with the zero of a joint, by differences.
Eigen::Vector3d changeByZero(const RobotModel& robot, const std::vector<JointAngles>& angles,
                             const Eigen::Vector3d& up_w, std::size_t link, std::size_t joint) {
  constexpr double kStep = 1e-6;
  std::vector<double> zeros(robot.joints().size(), 0.0);
  zeros[joint] = kStep;
  const LinkGravity moved(robot, angles, up_w, zeros);
  return (moved.up(link, 0) - LinkGravity(robot, angles, up_w).up(link, 0)) / kStep;
}

TEST(LinkGravity, GravityAndItsDerivativesAreThoseOfForwardKinematics) {
  const RobotModel robot = RobotModel::parse(armUrdf(), "arm.urdf");
  std::vector<JointAngles> angles(1);
  double angle = 0.3;
  for (const std::string& joint : robot.freeJointNames()) angles[0].positions[joint] = (angle *= -1.2);
  const Eigen::Vector3d up_w = Eigen::Vector3d(0.1, -0.2, 1).normalized();
  const LinkGravity gravity(robot, angles, up_w);
  const std::vector<SE3> T_w_l = robot.forward(angles[0]);
  for (std::size_t link = 0; link < robot.links().size(); ++link) {
    EXPECT_LT((T_w_l[link].R * gravity.up(link, 0) - up_w).norm(), 1e-12);
    for (const std::size_t joint : gravity.jointsTo(link)) {
      EXPECT_LT((changeByZero(robot, angles, up_w, link, joint) - gravity.byZero(link, 0, joint)).norm(), 1e-5);
    }
  }
  EXPECT_EQ(gravity.jointsTo(robot.linkNamed("base")).size(), 0U);
  EXPECT_EQ(gravity.jointsTo(robot.linkNamed("l4_cover")).size(), 4U);
  EXPECT_EQ(gravity.jointsTo(robot.linkNamed("finger")).size(), 6U) << "a joint that slides turns nothing";
}

TEST(LinkGravity, AMimickingJointTurnsWithTheOneItFollows) {
  const RobotModel robot = RobotModel::parse(R"(<robot name="two">
    <link name="base"/><link name="a"/><link name="b"/>
    <joint name="lead" type="continuous"><parent link="base"/><child link="a"/><axis xyz="1 0 0"/></joint>
    <joint name="follow" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/>
      <mimic joint="lead" multiplier="-2" offset="0.1"/></joint></robot>)",
                                             "two.urdf");
  std::vector<JointAngles> angles = {{{{"lead", 0.4}}}};
  const std::size_t lead = robot.jointNamed("lead");
  const std::size_t b = robot.linkNamed("b");
  const Eigen::Vector3d up_w = Eigen::Vector3d::UnitZ();
  const LinkGravity gravity(robot, angles, up_w);
  EXPECT_EQ(gravity.jointsTo(b), std::vector<std::size_t>{lead});
  EXPECT_LT((changeByZero(robot, angles, up_w, b, lead) - gravity.byZero(b, 0, lead)).norm(), 1e-5);

  // Named itself, it has an angle of its own, and the other one's zero does not turn it.
  angles[0].positions["follow"] = 0.2;
  const LinkGravity named(robot, angles, up_w);
  EXPECT_LT((changeByZero(robot, angles, up_w, b, lead) - named.byZero(b, 0, lead)).norm(), 1e-5);
}

}  // namespace
}  // namespace hexoderm
