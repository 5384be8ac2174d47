// KDL's own reader of URDF and its recursive solver, as ROS uses them, beside ours.
#include "hexoderm/robots/robot_model.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl_parser/kdl_parser.hpp>

namespace hexoderm {
namespace {

TEST(KdlParser, PutsTheLinksOfTheDemoArmWhereWeDo) {
  const RobotModel arm = RobotModel::read(HEXODERM_DEMO_ROBOT);
  KDL::Tree tree;
  ASSERT_TRUE(kdl_parser::treeFromFile(HEXODERM_DEMO_ROBOT, tree));
  KDL::TreeFkSolverPos_recursive solver(tree);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int trial = 0; trial < 20; ++trial) {
    JointAngles angles;
    KDL::JntArray q(tree.getNrOfJoints());
    for (const auto& [name, element] : tree.getSegments()) {
      const KDL::Joint& joint = element.segment.getJoint();
      if (joint.getType() == KDL::Joint::None) continue;
      angles.positions[joint.getName()] = q(element.q_nr) = angle(random);
    }
    const std::vector<SE3> T_w_l = arm.forward(angles);
    for (std::size_t link = 0; link < arm.links().size(); ++link) {
      KDL::Frame frame;
      ASSERT_GE(solver.JntToCart(q, frame, arm.links()[link].name), 0);
      for (int row = 0; row < 3; ++row) {
        EXPECT_NEAR(T_w_l[link].t[row], frame.p[row], 1e-12);
        for (int column = 0; column < 3; ++column) {
          EXPECT_NEAR(T_w_l[link].R(row, column), frame.M(row, column), 1e-12);
        }
      }
    }
  }
}

}  // namespace
}  // namespace hexoderm
