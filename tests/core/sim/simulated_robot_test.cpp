#include "hexoderm/sim/simulated_robot.h"

#include "hexoderm/base/mesh_feet.h"
#include "hexoderm/base/units.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

SimulatedRobot demoRobotWith(const SimulatedRobotOptions& options) {
  return {builtInCellModel("hex-bma150"), RobotModel::read(HEXODERM_DEMO_ROBOT), options};
}

SimulatedRobotOptions demoOptions(SimulatedRobotOptions options = {}) {
  options.mounts = demoMounts();
  return options;
}

/// Every cell's reading of a frame, by ID.
std::map<CellId, Eigen::Vector3d> readings(const SampleFrame& frame) {
  std::map<CellId, Eigen::Vector3d> result;
  for (const CellSample& sample : frame.samples) result[sample.cell] = sample.acceleration_g;
  return result;
}

TEST(SimulatedRobot, IdealCellsReadGravityInTheFramesThatTheTruthStates) {
  SimulatedRobotOptions options = demoOptions(SimulatedRobotOptions::ideal());
  options.zero_offset_sigma_rad = 2 * kDegree;
  options.base_tilt_sigma_rad = 1 * kDegree;
  SimulatedRobot robot = demoRobotWith(options);
  for (int k = 0; k < 3; ++k) {
    const SimulatedRobotPose pose = robot.nextPose();
    const std::vector<SE3> T_w_l = robot.robot().forward(pose.true_angles);
    const auto read = readings(robot.record(1).front());
    ASSERT_EQ(read.size(), 34U);
    for (const MountedPatch& patch : robot.patches()) {
      const SE3& T_w_link = T_w_l[robot.robot().linkNamed(patch.link)];
      for (std::size_t c = 0; c < patch.cells.size(); ++c) {
        const Eigen::Matrix3d R_w_a = T_w_link.R * patch.T_l_u[c].R * robot.model().accelerometer.T_u_a.R;
        EXPECT_LT((read.at(patch.cells[c]) - R_w_a.transpose() * pose.up_w).norm(), 1e-12);
      }
    }
  }
}

TEST(SimulatedRobot, TheRobotReportsAnglesThatMissTheTruthByItsZeroOffsets) {
  SimulatedRobotOptions options = demoOptions();
  options.zero_offset_sigma_rad = 2 * kDegree;
  SimulatedRobot robot = demoRobotWith(options);
  const SimulatedRobotPose pose = robot.nextPose();
  EXPECT_EQ(pose.reported.positions.size(), 5U);
  EXPECT_GT(std::abs(robot.zeroOffsets().positions.at("elbow")), 0);
  EXPECT_EQ(robot.zeroOffsets().positions.at("grip"), 0) << "offsets are angles";
  for (const auto& [joint, position] : pose.reported.positions) {
    EXPECT_NEAR(pose.true_angles.positions.at(joint) - position, robot.zeroOffsets().positions.at(joint), 1e-15);
    const JointLimits limits = *robot.robot().joints()[robot.robot().jointNamed(joint)].limits;
    EXPECT_GE(position, limits.lower);
    EXPECT_LE(position, limits.upper);
  }
  EXPECT_GT(angleBetween(pose.up_w, Eigen::Vector3d::UnitZ()), 0) << "the base is tilted";
  EXPECT_LT(angleBetween(pose.up_w, Eigen::Vector3d::UnitZ()), 5 * kDegree);
}

TEST(SimulatedRobot, TheBacksOfTheCellsLieOnTheLinksBody) {
  SimulatedRobot robot = demoRobotWith(demoOptions(SimulatedRobotOptions::ideal()));
  for (const MountedPatch& patch : robot.patches()) {
    const TriangleMesh body = robot.robot().bodyOf(robot.robot().linkNamed(patch.link));
    const MeshSurface surface(body, patch.T_l_u.front());
    for (const SE3& T_l_u : patch.T_l_u) {
      const Eigen::Vector3d back = T_l_u * Eigen::Vector3d(0, 0, -robot.model().thickness_m);
      EXPECT_LT((surface.project(back) - back).norm(), 1e-6) << patch.link;
      EXPECT_LT(angleBetween(surface.normal(back), T_l_u.R.col(2)), 1e-3) << patch.link;
    }
  }
}

TEST(SimulatedRobot, InAHandTheWholeRobotIsOneRigidBodyThatTrembles) {
  SimulatedRobotOptions options = SimulatedRobotOptions::ideal();
  options.base = BaseHold::Hand;
  options.skin.tremor_acceleration_g = 0.01;
  // Both on one link, and so far from a rotation centre that the field matters little.
  options.mounts = {{"forearm", {Eigen::Matrix3d::Identity(), {0, 0, 0.1}}, "ring3", "plane"},
                    {"forearm", {rotationFromRpy({0.3, 0.2, 0.1}), {0, 0, 0.1}}, "ring3", "plane"}};
  SimulatedRobot robot = demoRobotWith(options);
  robot.nextPose();
  const SimulatedRobotPose pose = robot.nextPose();
  EXPECT_GT(angleBetween(pose.up_w, Eigen::Vector3d::UnitZ()), 5 * kDegree) << "turned anew";
  const std::vector<SampleFrame> frames = robot.record(50);
  const Eigen::Matrix3d R_a = robot.model().accelerometer.T_u_a.R;
  double moved = 0;
  const auto first = readings(frames.front());
  for (const SampleFrame& frame : frames) {
    const auto read = readings(frame);
    Eigen::Vector3d seen[2];
    for (std::size_t p = 0; p < 2; ++p) {
      const MountedPatch& patch = robot.patches()[p];
      seen[p] = patch.T_l_u[1].R * R_a * read.at(patch.cells[1]);
    }
    EXPECT_LT((seen[0] - seen[1]).norm(), 0.02) << "the same body";
    moved = std::max(moved, (read.at(CellId(1)) - first.at(CellId(1))).norm());
  }
  EXPECT_GT(moved, 1e-3) << "it trembles";
}

TEST(SimulatedRobot, PutsThePatchesMiddleWhereItIsMounted) {
  SimulatedRobotOptions options = SimulatedRobotOptions::ideal();
  const SE3 T_l_m{rotationFromRpy({0.3, -0.4, 1.0}), {0.1, 0.2, 0.3}};
  options.mounts = {{"hand", T_l_m, "x17", "cylinder:r=0.06"}};
  const SimulatedRobot robot = demoRobotWith(options);
  const SE3& T_l_u = robot.patches()[0].T_l_u.front();
  EXPECT_LT((T_l_u.t - T_l_m.t).norm(), 1e-12);
  EXPECT_LT((T_l_u.R.col(2) - T_l_m.R.col(2)).norm(), 1e-12);
}

TEST(SimulatedRobot, NumbersCellsMountByMountAndNamesPartsNotLinks) {
  const SimulatedRobot robot = demoRobotWith(demoOptions());
  ASSERT_EQ(robot.neighbors().size(), 34U);
  for (std::size_t k = 0; k < 34; ++k) {
    EXPECT_EQ(robot.neighbors()[k].id, CellId(static_cast<std::uint32_t>(k + 1)));
    for (const NeighborReport& neighbor : robot.neighbors()[k].neighbors) {
      EXPECT_EQ((neighbor.cell.value() - 1) / 17, k / 17) << "no link between the patches";
    }
  }
  EXPECT_EQ(robot.patches()[0].part, "upper_arm");
  EXPECT_EQ(robot.patches()[1].cells.front(), CellId(18));
  EXPECT_EQ(robot.groundTruth().cells.size(), 34U);
}

TEST(SimulatedRobot, FollowsFromItsSeed) {
  const auto first = [](std::uint64_t seed) {
    SimulatedRobotOptions options = demoOptions();
    options.seed = seed;
    SimulatedRobot robot = demoRobotWith(options);
    robot.nextPose();
    return readings(robot.record(1).front()).at(CellId(20));
  };
  EXPECT_EQ(first(1), first(1));
  EXPECT_NE(first(1), first(2));
}

TEST(SimulatedRobot, RefusesWhatMakesNoRobot) {
  const auto complaint = [](SimulatedRobotOptions options) {
    return messageOf<InvalidArgument>([&] { demoRobotWith(options); });
  };
  EXPECT_THAT(complaint({}), saysAll("at least one patch"));
  SimulatedRobotOptions options;
  options.mounts = {{"fore_arm", {}}};
  EXPECT_THAT(complaint(options), saysAll("fore_arm", "did you mean forearm?"));
  options = demoOptions();
  options.zero_offset_sigma_rad = -1;
  EXPECT_THAT(complaint(options), saysAll("zero_offset_sigma_rad"));
  SimulatedRobot robot = demoRobotWith(demoOptions());
  EXPECT_THROW(robot.record(), InvalidArgument) << "no pose yet";
}

}  // namespace
}  // namespace hexoderm
