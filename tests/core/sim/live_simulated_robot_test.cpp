#include "hexoderm/sim/robot_text.h"
#include "hexoderm/sim/simulated_robot.h"

#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

#include <stdexcept>

namespace hexoderm {
namespace {

RobotText idealDemo() {
  RobotText words;
  words.robot = "demo";
  words.ideal = true;
  return words;
}

SimulatedRobot demoRobot(const RobotText& words = idealDemo()) {
  return makeRobot(builtInCellModel("hex-bma150"), words);
}

/// Where the accelerometer of a cell is in the base, were the joints as an ideal robot reports them.
SE3 placeOf(const SimulatedRobot& robot, CellId cell, const JointAngles& angles) {
  const std::vector<SE3> T_w_l = robot.robot().forward(angles);
  for (const MountedPatch& patch : robot.patches()) {
    const auto found = std::ranges::find(patch.cells, cell);
    if (found == patch.cells.end()) continue;
    const auto k = static_cast<std::size_t>(found - patch.cells.begin());
    return T_w_l[robot.robot().linkNamed(patch.link)] * patch.T_l_u[k] * robot.model().accelerometer.T_u_a;
  }
  throw std::runtime_error("there is no such cell");
}

/// Up in the cell's frame, were the joints so.
Eigen::Vector3d upIn(const SimulatedRobot& robot, CellId cell, const JointAngles& angles) {
  return robot.model().accelerometer.T_u_a.R * placeOf(robot, cell, angles).R.transpose() * Eigen::Vector3d::UnitZ();
}

Eigen::Vector3d readingOf(const SampleFrame& frame, CellId cell) {
  for (const CellSample& sample : frame.samples) {
    if (sample.cell == cell) return sample.acceleration_g;
  }
  throw std::runtime_error("the cell sent nothing");
}

TEST(LiveSimulatedRobot, CellsFeelTheWayOfTheJoints) {
  SimulatedRobot robot = demoRobot();
  robot.next();
  const JointAngles before = robot.jointAngles();
  robot.turnToNextPose();
  EXPECT_TRUE(robot.turning());
  std::vector<JointAngles> angles;
  std::vector<SampleFrame> frames;
  while (robot.turning()) {
    ASSERT_LT(frames.size(), 20'000U);
    angles.push_back(robot.jointAngles());
    frames.push_back(robot.next());
  }
  for (const auto& [joint, position] : before.positions) {
    EXPECT_NEAR(angles.front().positions.at(joint), position, 1e-12) << "it begins where it stood";
  }
  EXPECT_GT(frames.size(), 500U);
  const double tick_s = 1 / robot.rate_hz();
  double most_g = 0;
  for (const CellId cell : {CellId(5), CellId(30)}) {
    for (std::size_t k = 1; k + 1 < frames.size(); ++k) {
      const SE3 now = placeOf(robot, cell, angles[k]);
      const Eigen::Vector3d acceleration =
          (placeOf(robot, cell, angles[k - 1]).t - 2 * now.t + placeOf(robot, cell, angles[k + 1]).t) /
          (tick_s * tick_s);
      const Eigen::Vector3d force_w = Eigen::Vector3d::UnitZ() + acceleration / kStandardGravity;
      ASSERT_LT((readingOf(frames[k], cell) - now.R.transpose() * force_w).norm(), 1e-6)
          << toString(cell) << ", tick " << k;
      most_g = std::max(most_g, acceleration.norm() / kStandardGravity);
      for (const auto& [joint, position] : angles[k].positions) {
        ASSERT_LE(std::abs(position - angles[k - 1].positions.at(joint)), 61 * kDegree * tick_s) << joint;
      }
    }
  }
  EXPECT_GT(most_g, 0.001) << "not gravity alone";
  const JointAngles after = robot.jointAngles();
  const SampleFrame held = robot.next();
  EXPECT_EQ(robot.jointAngles(), after);
  EXPECT_LT(
      (readingOf(held, CellId(30)) - placeOf(robot, CellId(30), after).R.transpose() * Eigen::Vector3d::UnitZ()).norm(),
      1e-12);
}

TEST(LiveSimulatedRobot, OnAFixedBaseItsJointsTurnACellAsNearAsTheyCan) {
  SimulatedRobot robot = demoRobot();
  JointAngles wanted;
  for (const std::string& joint : robot.robot().freeJointNames()) {
    const JointLimits limits = *robot.robot().joints()[robot.robot().jointNamed(joint)].limits;
    wanted.positions[joint] = 0.3 * limits.lower + 0.7 * limits.upper;
  }
  for (const CellId cell : {CellId(3), CellId(25)}) {
    const Eigen::Vector3d up_u = upIn(robot, cell, wanted);
    robot.turnTo(cell, up_u);
    while (robot.turning()) robot.skip(10);
    EXPECT_LT(angleBetween(upIn(robot, cell, robot.jointAngles()), up_u), 15 * kDegree) << toString(cell);
  }
}

TEST(LiveSimulatedRobot, InAHandItIsTurnedWhereverItIsAskedTo) {
  RobotText words = idealDemo();
  words.base = "hand";
  SimulatedRobot robot = demoRobot(words);
  JointAngles angles = robot.jointAngles();
  for (const Eigen::Vector3d& up_u : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 1, 1)}) {
    robot.turnTo(CellId(20), up_u);
    while (robot.turning()) robot.next();
    EXPECT_NE(robot.jointAngles(), angles) << "its joints move, too";
    angles = robot.jointAngles();
    const Eigen::Vector3d felt_u = robot.model().accelerometer.T_u_a.R * readingOf(robot.next(), CellId(20));
    EXPECT_LT(angleBetween(felt_u, up_u), 15 * kDegree) << "a hand misses by a few degrees";
  }
  robot.turnTo(Eigen::Vector3d::UnitX());
  EXPECT_EQ(robot.jointAngles(), angles) << "of the base alone";
  while (robot.turning()) robot.next();
  EXPECT_EQ(robot.jointAngles(), angles);
}

TEST(LiveSimulatedRobot, MissesWhatItReportsByItsZeroOffsets) {
  RobotText words;
  words.robot = "demo";
  SimulatedRobot robot = demoRobot(words);
  robot.turnToNextPose();
  JointAngles reported = robot.jointAngles();
  for (int k = 0; k < 300; ++k) robot.next();
  EXPECT_NE(robot.jointAngles(), reported);
  while (robot.turning()) robot.skip(1);
  // Reported exactly, as in a pose that is recorded.
  SimulatedRobot same = demoRobot(words);
  same.nextPose();
  EXPECT_EQ(robot.jointAngles(), same.nextPose().reported);
}

TEST(LiveSimulatedRobot, ItsCellsBreakByTheRobotsNumbers) {
  RobotText words = idealDemo();
  words.faults = {{SkinFault::Dead, CellId(20)}};
  SimulatedRobot robot = demoRobot(words);
  SampleFrame frame = robot.next();
  EXPECT_EQ(readingOf(frame, CellId(20)), Eigen::Vector3d::Zero());
  EXPECT_NEAR(readingOf(frame, CellId(3)).norm(), 1, 1e-6);
  robot.breakCell({SkinFault::NoSamples, CellId(21)});
  EXPECT_THAT(robot.next().samples, SizeIs(33));
  robot.mendCell(CellId(21));
  robot.mendCell(CellId(20));
  frame = robot.next();
  EXPECT_THAT(frame.samples, SizeIs(34));
  EXPECT_NEAR(readingOf(frame, CellId(20)).norm(), 1, 1e-6);

  const LinkFault fault{LinkFaultKind::WrongPort, {CellId(20), PortNumber(1)}};
  const std::unique_ptr<SimulatedBody> other = robot.withLinkFaults({fault});
  EXPECT_THAT(other->cellFaults(), SizeIs(0));
  EXPECT_THAT(other->linkFaults(), SizeIs(1));
  for (std::size_t k = 0; k < 17; ++k) EXPECT_EQ(other->neighbors()[k], robot.neighbors()[k]);
  EXPECT_NE(other->neighbors()[19], robot.neighbors()[19]);
}

TEST(LiveSimulatedRobot, RefusesWhatItCantDo) {
  using test::messageOf;
  using test::saysAll;
  SimulatedRobot robot = demoRobot();
  const auto complaint = [&](const auto& action) { return messageOf<InvalidArgument>(action); };
  EXPECT_THAT(complaint([&] { robot.turnTo(Eigen::Vector3d::UnitX()); }), saysAll("base is fixed"));
  EXPECT_THAT(complaint([&] { robot.turnTo(CellId(35), Eigen::Vector3d::UnitX()); }), saysAll("cell 35", "1 to 34"));
  EXPECT_THAT(complaint([&] { robot.turnTo(CellId(1), Eigen::Vector3d::Zero()); }), saysAll("finite vector"));
  EXPECT_THROW(robot.turnTo(CellId(1), {0, std::numeric_limits<double>::quiet_NaN(), 1}), InvalidArgument);
  EXPECT_THROW(robot.breakCell({SkinFault::Dead, CellId(0)}), InvalidArgument);
  EXPECT_THAT(complaint([&] {
                static_cast<void>(robot.withLinkFaults({{LinkFaultKind::Joint, {CellId(35), PortNumber(1)}}}));
              }),
              saysAll("cell 35"));

  SimulatedRobotOptions options = SimulatedRobotOptions::ideal();
  options.mounts = {{"block", {}, "sheet:1x1", "plane"}};
  SimulatedRobot block(builtInCellModel("hex-bma150"),
                       RobotModel::parse("<robot name='block'><link name='block'/></robot>", "block.urdf"), options);
  EXPECT_THAT(complaint([&] { block.turnTo(CellId(1), -Eigen::Vector3d::UnitZ()); }),
              saysAll("can't turn cell 1 there", "180"));
  EXPECT_FALSE(block.turning());
  EXPECT_TRUE(block.jointAngles().positions.empty());
  block.turnTo(CellId(1), Eigen::Vector3d::UnitZ());
  block.next();
  EXPECT_FALSE(block.turning()) << "it is there already";
}

}  // namespace
}  // namespace hexoderm
