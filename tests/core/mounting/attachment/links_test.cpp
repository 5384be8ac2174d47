#include "hexoderm/mounting/attachment/links.h"

#include "hexoderm/base/median.h"
#include "hexoderm/mounting/attachment/link_fit.h"
#include "hexoderm/robots/demo_robot.h"
#include "hexoderm/sim/simulated_robot.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/mounting/attachment/drawn_links.h"
#include "tests/support/options.h"
#include "tests/support/slow_build.h"

#include <regex>

namespace hexoderm {
namespace {

std::vector<std::string> namesOf(const LinkCandidate& candidate) { return collect(candidate.links, &PatchTurn::link); }
/// The operator says which link a patch is on.
LinksOptions chosen(CellId origin, const std::string& link) {
  return test::with(withoutLever(), &LinksOptions::chosen, {{origin, link}});
}
std::vector<std::string> findingsOf(const LinksResult& result) { return collect(result.findings, &Message::english); }
TEST(Links, WithoutErrorsAreExact) {
  const DrawnArmOptions options{
      .links = {"l3", "l6", "l4_cover"}, .error_scale = 0, .zero_sigma_rad = 0, .tilt_sigma_rad = 0};
  const DrawnArm arm(options);
  const LinksResult result = arm.find();
  ASSERT_EQ(result.patches.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const PatchLinks& patch = result.patches[k];
    ASSERT_TRUE(patch.placed.has_value()) << patch.why;
    EXPECT_NEAR(patch.candidates.front().chi_squared, 0, 1e-12);
    for (const PatchTurn& turn : patch.candidates.front().links) {
      if (turn.link == options.links[k]) {
        EXPECT_LT(logSO3(turn.R_l_o.transpose() * arm.R_l_o[k]).norm(), 1e-9) << turn.link;
      }
    }
    for (const LinkResidual& residual : patch.residuals) EXPECT_LT(residual.angle_rad, 1e-9);
  }
  EXPECT_EQ(result.patches[0].placed->link, "l3");
  EXPECT_THAT(namesOf(result.patches[1].candidates.front()), ::testing::ElementsAre("l6", "finger"))
      << "what slides is not told apart";
  EXPECT_EQ(namesOf(result.patches[2].candidates.front()), (std::vector<std::string>{"l4", "l4_cover"}));
  for (const JointZero& zero : result.robot->zeros) EXPECT_LT(std::abs(zero.zero_rad), 1e-9);
  EXPECT_LT(result.robot->tilt_rad, 1e-9);
  for (const JointResidual& residual : result.robot->residuals) EXPECT_LT(std::abs(residual.turn_rad), 1e-8);
  EXPECT_EQ(result.robot->covariance.size(), result.robot->unknowns() * result.robot->unknowns());
}

constexpr int kSeeds = test::kSlowBuild ? 5 : 100;

/// Of arms with seeds from that of the options on.
LinksTally tallyOfArms(DrawnArmOptions options, const std::string& name) {
  LinksTally tally;
  for (int k = 0; k < kSeeds; ++k, ++options.seed) {
    const DrawnArm arm(options);
    tally.add(arm.find(), arm.truth());
  }
  EXPECT_EQ(tally.wrong, 0) << name;
  EXPECT_LE(tally.none, 0.01 * tally.patches) << name;
  return tally;
}

// Errors as stated: the right link, and uncertainties that agree with the truth.
TEST(Links, AreRightAndStateHowWellTheyKnow) {
  for (const std::size_t poses : {4U, 8U}) {
    const DrawnArmOptions options{.links = {"l2", "l3", "l4", "l6"}, .poses = poses};
    const LinksTally tally = tallyOfArms(options, std::to_string(poses) + " poses");
    if (test::kSlowBuild) continue;
    EXPECT_GT(meanOf(tally.turn_nees), 0.7);
    EXPECT_LT(meanOf(tally.turn_nees), 1.5);
    EXPECT_LE(median(tally.errors_rad), 1.2 * median(tally.stated_rad));
    EXPECT_FALSE(tally.zero_nees.empty());
    EXPECT_LT(meanOf(tally.zero_nees), 1.5);
    EXPECT_LT(meanOf(tally.tilt_nees), 1.5);
  }
}

// Four times what the prior says: links are still found, and zeros within their stated sigma.
TEST(Links, ZerosOfTwoDegreesAreFound) {
  const DrawnArmOptions options{.links = {"l2", "l4", "l6"}, .poses = 8, .seed = 1001, .zero_sigma_rad = 2 * kDegree};
  const LinksTally tally = tallyOfArms(options, "zeros of 2 degrees");
  if (test::kSlowBuild) return;
  EXPECT_GT(meanOf(tally.zero_nees), 0.5);
  EXPECT_LT(meanOf(tally.zero_nees), 1.5);
  EXPECT_LT(meanOf(tally.turn_nees), 1.5);
}

TEST(Links, ALargeZeroIsSaid) {
  DrawnArm arm(DrawnArmOptions{.links = {"l2", "l4", "l6"}, .poses = 12, .zero_sigma_rad = 0});
  for (auto& [pose, angles] : arm.angles) angles.positions["j4"] -= 3 * kDegree;
  const LinksResult result = arm.find();
  EXPECT_THAT(findingsOf(result), Contains(HasSubstr("The zero of joint j4 seems to be off")));
  const auto zero = std::ranges::find(result.robot->zeros, "j4", &JointZero::joint);
  ASSERT_NE(zero, result.robot->zeros.end());
  EXPECT_TRUE(zero->shown);
  EXPECT_NEAR(zero->zero_rad, 3 * kDegree, 3 * zero->sigma_rad);
  const LinksOptions exact = test::with(withoutLever(), &LinksOptions::joint_zeros, false);
  for (const JointZero& none : arm.find(exact).robot.value_or(RobotEstimate()).zeros) EXPECT_EQ(none.zero_rad, 0);
}

// --- what can't be told

TEST(Links, OnePoseFitsAnyLink) {
  const LinksResult result = DrawnArm(DrawnArmOptions{.poses = 1}).find();
  const PatchLinks& patch = result.patches.front();
  EXPECT_FALSE(patch.placed.has_value());
  ASSERT_EQ(patch.candidates.size(), 1U);
  EXPECT_EQ(patch.candidates.front().links.size(), 9U);
  EXPECT_THAT(patch.why.english(), HasSubstr("can't be told from one pose"));
  ASSERT_TRUE(patch.open_axis_l.has_value());
  EXPECT_FALSE(result.robot.has_value());
}

TEST(Links, WithAJointBetweenThatNeverMovedAreOneCandidate) {
  DrawnArm still(DrawnArmOptions{.links = {"l5"}, .poses = 8});
  for (auto& [pose, angles] : still.angles) angles.positions["j6"] = 0.4;
  const LinksResult result = still.find();
  const PatchLinks& patch = result.patches.front();
  ASSERT_EQ(patch.candidates.size(), 1U) << patch.why;
  EXPECT_THAT(namesOf(patch.candidates.front()), ::testing::ElementsAre("l5", "l6", "finger"));
  EXPECT_FALSE(patch.placed.has_value()) << "the operator picks";
  EXPECT_THAT(patch.why.english(), HasSubstr("which these poses can't tell apart: l5, l6 and finger"));
  EXPECT_THAT(patch.what_would_tell.english(), HasSubstr("from pose to pose, with their axes level: j6"));

  const LinksResult placed = still.find(chosen(patch.origin, "l6"));
  ASSERT_TRUE(placed.patches.front().placed.has_value());
  EXPECT_EQ(placed.patches.front().placed->link, "l6");
  EXPECT_TRUE(placed.patches.front().chosen);
}

TEST(Links, OnTheBaseTheTurnAboutTheVerticalStaysOpen) {
  const DrawnArmOptions options{.links = {"base"}};
  const LinksResult result = DrawnArm(options).find();
  const PatchLinks& patch = result.patches.front();
  ASSERT_EQ(patch.candidates.size(), 1U);
  EXPECT_EQ(namesOf(patch.candidates.front()), (std::vector<std::string>{"base", "l1"})) << "j1 is upright";
  ASSERT_TRUE(patch.open_axis_l.has_value());
  EXPECT_LT(angleBetween(patch.open_axis_l->cwiseAbs(), Eigen::Vector3d::UnitZ()), 5 * kDegree);
  EXPECT_THAT(patch.why.english(), HasSubstr("about one axis is not determined"));
  EXPECT_THAT(patch.what_would_tell.english(), HasSubstr("with their axes level: j1"));
  EXPECT_THAT(DrawnArm(options).find(chosen(patch.origin, "base")).patches.front().what_would_tell.english(),
              HasSubstr("No joint moves link base"));
}

// How the base is tilted and how the patch is turned about the vertical can't be told apart there, however much the
// base seems to be tilted.
TEST(Links, OnTheBaseATiltSaysNothingOfTheTurnAboutTheVertical) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const DrawnArmOptions options{.links = {"l1"}, .poses = 8, .seed = seed, .tilt_sigma_rad = 3 * kDegree};
    const LinksResult result = DrawnArm(options).find();
    ASSERT_FALSE(result.patches.front().candidates.empty());
    for (const PatchTurn& turn : result.patches.front().candidates.front().links) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(turn.covariance, Eigen::EigenvaluesOnly);
      EXPECT_GT(std::sqrt(solver.eigenvalues()[2]), 0.9) << turn.link << ", seed " << seed;
    }
  }
}

// The joints hardly move: gravity comes from one direction, and nothing tells links apart.
TEST(Links, OnOneLineTheTurnAboutItStaysOpen) {
  const LinksResult result = DrawnArm(DrawnArmOptions{.links = {"l6"}, .range_rad = 0.0005}).find();
  const PatchLinks& patch = result.patches.front();
  ASSERT_EQ(patch.candidates.size(), 1U) << patch.why;
  EXPECT_EQ(patch.candidates.front().links.size(), 9U);
  ASSERT_TRUE(patch.open_axis_l.has_value());
  EXPECT_THAT(patch.why.english(), HasSubstr("gravity came along one line in all poses"));
  EXPECT_FALSE(patch.what_would_tell.empty());
}

TEST(Links, APatchOnNoLinkIsOnNone) {
  DrawnArm arm(DrawnArmOptions{.links = {"l3", "l6"}, .poses = 8});
  // What a body sees that turns by itself.
  GravityDraw draw(77);
  arm.reconstruction.patches[1] = patchThatSaw(draw.see(draw.directions(8), {}), 1);
  const LinksResult result = arm.find();
  EXPECT_TRUE(result.patches[0].placed.has_value());
  const PatchLinks& lost = result.patches[1];
  EXPECT_TRUE(lost.candidates.empty());
  EXPECT_FALSE(lost.placed.has_value());
  ASSERT_TRUE(lost.nearest.has_value());
  EXPECT_THAT(lost.why.english(), HasSubstr("fits no link"));
  EXPECT_THAT(findingsOf(result), Contains(lost.why.english()));
  EXPECT_EQ(result.robot->patches.size(), 1U);

  const LinksResult forced = arm.find(chosen(lost.origin, "l5"));
  ASSERT_TRUE(forced.patches[1].placed.has_value()) << "the operator's word counts";
  EXPECT_THAT(findingsOf(forced), Contains(HasSubstr("was put on link l5, which doesn't fit")));
}

// --- mistakes in the angles

/// With a mistake in the angles of every pose.
LinksResult findWith(const DrawnArmOptions& options, const std::function<void(JointAngles&)>& mistake) {
  DrawnArm arm(options);
  for (auto& [pose, angles] : arm.angles) mistake(angles);
  return arm.find();
}

TEST(Links, DegreesReadAsRadiansAreNoticed) {
  const auto findingsWith = [](double factor) {
    return findingsOf(findWith({.poses = 8, .range_rad = 1.2}, [factor](JointAngles& angles) {
      for (auto& [joint, angle] : angles.positions) angle *= factor;
    }));
  };
  EXPECT_THAT(findingsWith(toDegrees(1)),
              Contains(HasSubstr("probably degrees that were read as rad: as degrees they fit")));
  EXPECT_THAT(findingsWith(kDegree), Contains(HasSubstr("probably rad that were read as degrees")));
}

TEST(Links, AJointThatCountsTheOtherWayRoundOrWhoseZeroIsFarOffIsNamed) {
  for (const auto& [factor, offset_rad, text] :
       {std::tuple(-1.0, 0.0, "Joint j4 seems to count its angle the other way round"),
        std::tuple(1.0, -kPi / 2, "The zero of joint j4 seems to be off by about")}) {
    const LinksResult result = findWith({.links = {"l6"}, .poses = 8}, [&, f = factor, o = offset_rad](JointAngles& a) {
      a.positions["j4"] = f * a.positions["j4"] + o;
    });
    EXPECT_TRUE(result.patches.front().candidates.empty());
    EXPECT_THAT(findingsOf(result), Contains(HasSubstr(text)));
  }
}

TEST(Links, AnglesThatAreOffByOnePoseAreSaid) {
  const DrawnArmOptions options{.poses = 8};
  const DrawnArm right(options);
  DrawnArm later(options);
  DrawnArm earlier(options);
  for (std::uint32_t pose = 1; pose < 8; ++pose) {
    later.angles[PoseId(pose + 1)] = right.angles.at(PoseId(pose));
    earlier.angles[PoseId(pose)] = right.angles.at(PoseId(pose + 1));
  }
  EXPECT_THAT(findingsOf(later.find()), Contains(HasSubstr("off by one pose: with those of the pose after it")));
  EXPECT_THAT(findingsOf(earlier.find()), Contains(HasSubstr("off by one pose: with those of the pose before it")));
  EXPECT_THAT(findingsOf(right.find()), ::testing::Not(Contains(HasSubstr("off by one pose"))));
}

TEST(Links, APoseWithTheAnglesOfAnotherOneIsNamed) {
  DrawnArm arm(DrawnArmOptions{.poses = 8});
  arm.angles[PoseId(3)].positions["j2"] += 1;
  arm.angles[PoseId(3)].positions["j4"] -= 1;
  EXPECT_THAT(findingsOf(arm.find()), Contains(HasSubstr("Pose 3 doesn't go with the others")));
}

TEST(Links, ABaseThatHangsOrMovedIsSaid) {
  const DrawnArmOptions options{.poses = 8};
  const DrawnArm arm(options);
  const LinksOptions hanging = test::with(withoutLever(), &LinksOptions::up_w, -Eigen::Vector3d::UnitZ());
  EXPECT_THAT(findingsOf(arm.find(hanging)), Contains(HasSubstr("the patches fit with +z of its frame upwards")));

  DrawnArm moved(options);
  GravityDraw draw(5);
  const std::vector<Eigen::Vector3d> up = draw.directions(8);  // of a base in a hand
  for (std::size_t k = 0; k < options.links.size(); ++k) {
    std::vector<Eigen::Vector3d> seen;
    std::size_t pose = 0;
    for (const auto& [id, angles] : moved.angles) {
      const SE3 T_w_l = moved.robot.forward(angles)[moved.robot.linkNamed(options.links[k])];
      seen.emplace_back((T_w_l.R * moved.R_l_o[k]).transpose() * up[pose++]);
    }
    moved.reconstruction.patches[k] = patchThatSaw(draw.see(seen, {}), static_cast<std::uint32_t>(k));
  }
  const LinksResult result = moved.find();
  for (const PatchLinks& patch : result.patches) EXPECT_TRUE(patch.candidates.empty()) << patch.why;
  EXPECT_THAT(findingsOf(result), Contains(HasSubstr("perhaps the robot's base did not stand still")));
}

TEST(Links, PosesAndLinksWithoutAnglesAreLeftOut) {
  DrawnArm arm(DrawnArmOptions{.links = {"l3"}, .poses = 8});
  arm.angles.erase(PoseId(2));
  arm.angles[PoseId(5)].positions.erase("j2");
  for (auto& [pose, angles] : arm.angles) angles.positions.erase("j6");
  const LinksResult result = arm.find();
  EXPECT_EQ(result.poses.size(), 6U);
  EXPECT_THAT(findingsOf(result), Contains(HasSubstr("which are not compared: 2")));
  EXPECT_THAT(findingsOf(result), Contains("Pose 5 is not compared, because it lacks the angles of these joints: j2."));
  EXPECT_THAT(findingsOf(result), Contains(HasSubstr("links beyond them are not compared: j6")));
  ASSERT_TRUE(result.patches.front().placed.has_value()) << result.patches.front().why;
  EXPECT_EQ(result.patches.front().placed->link, "l3");

  arm.angles.clear();
  const LinksResult none = arm.find();
  EXPECT_TRUE(none.patches.empty());
  EXPECT_EQ(none.not_compared.size(), 1U);
  EXPECT_THAT(none.summary.english(), HasSubstr("No pose has joint angles"));
}

TEST(Links, BadInputIsRefusedText) {
  const DrawnArm arm(DrawnArmOptions{});
  for (const auto& [cell, link, says] : {std::tuple(100U, "l33", "l33"), std::tuple(7U, "l3", "no cell 7")}) {
    const LinksOptions options = chosen(CellId(cell), link);
    EXPECT_THAT(messageOf<InvalidArgument>([&] { static_cast<void>(arm.find(options)); }), HasSubstr(says));
  }

  DrawnArm filed(DrawnArmOptions{});
  for (PatchReconstruction& patch : filed.reconstruction.patches) patch.gravity_covariance = nullptr;
  EXPECT_THAT(messageOf<InvalidArgument>([&] { static_cast<void>(filed.find()); }), HasSubstr("just solved"));

  for (const LinksOptions& spoiled :
       {test::with(&LinksOptions::up_w, {0, 0, 0}), test::with(&LinksOptions::false_alarm, 0),
        test::with(&LinksOptions::zero_sigma_rad, -1), test::with(&LinksOptions::tilt_sigma_rad, -1),
        test::with(&LinksOptions::lever_m, -1), test::with(&LinksOptions::test_lever_m, -1),
        test::with(&LinksOptions::most_poses, 1)}) {
    EXPECT_THROW(spoiled.validate(), InvalidArgument);
  }
}

// --- invariances

/// Both place all patches alike: on links whose names end alike, and turned by Q against each other.
void expectSameLinks(const LinksResult& before, const LinksResult& after,
                     const Eigen::Matrix3d& Q = Eigen::Matrix3d::Identity()) {
  ASSERT_EQ(before.patches.size(), after.patches.size());
  for (std::size_t k = 0; k < before.patches.size(); ++k) {
    ASSERT_TRUE(before.patches[k].placed && after.patches[k].placed);
    const PatchTurn& turn = *before.patches[k].placed;
    const PatchTurn& other = *after.patches[k].placed;
    EXPECT_THAT(other.link, ::testing::EndsWith(turn.link));
    EXPECT_LT((turn.R_l_o * Q - other.R_l_o).norm(), 1e-6);
    EXPECT_LT((Q.transpose() * turn.covariance * Q - other.covariance).norm(), 1e-6);
    EXPECT_EQ(before.patches[k].candidates.size(), after.patches[k].candidates.size());
  }
  EXPECT_NEAR(before.robot->chi_squared, after.robot->chi_squared, 1e-6);
}

TEST(Links, DoNotDependOnThePatchsFrame) {
  const DrawnArm arm(DrawnArmOptions{});
  DrawnArm turned = arm;
  const Eigen::Matrix3d Q = expSO3({0.7, -1.1, 2});
  for (std::size_t k = 0; k < arm.seen.size(); ++k) {
    turned.reconstruction.patches[k] =
        patchThatSaw(turnedBy(Q.transpose(), arm.seen[k]), static_cast<std::uint32_t>(k));
  }
  expectSameLinks(arm.find(), turned.find(), Q);
}

/// The same robot, with links and joints called otherwise and written in the opposite order.
std::string renamedArm() {
  static const std::regex kElement("<link [^>]*/>|<joint [\\s\\S]*?</joint>");
  const std::string urdf = armUrdf();
  std::string text;
  for (std::sregex_iterator element(urdf.begin(), urdf.end(), kElement), end; element != end; ++element) {
    text = element->str() + text;
  }
  // The first letters sort the links otherwise.
  for (const std::string name : {"base", "l1", "l2", "l3", "l4", "l4_cover", "l5", "l6", "finger"}) {
    const std::string other = static_cast<char>('z' - name.back() % 20) + ("_" + name);
    text = std::regex_replace(text, std::regex('"' + name + '"'), '"' + other + '"');
  }
  return "<robot name=\"arm\">" + text + "</robot>";
}

TEST(Links, DoNotDependOnNamesAndOrderOfTheFile) {
  const DrawnArm arm(DrawnArmOptions{});
  const RobotModel renamed = RobotModel::parse(renamedArm(), "renamed.urdf");
  expectSameLinks(arm.find(), findLinks(arm.reconstruction, renamed, arm.angles, withoutLever()));
}

// A robot that hangs from the ceiling.
TEST(Links, TheBaseMayStandOtherwise) {
  const DrawnArm arm(DrawnArmOptions{});
  const std::string hung =
      replaced(armUrdf(), R"(<origin xyz="0 0 0.3"/>)", R"(<origin xyz="0 0 0.3" rpy="3.141592653589793 0 0"/>)");
  LinksOptions find = withoutLever();
  const LinksResult standing = arm.find(find);
  find.up_w = -2 * Eigen::Vector3d::UnitZ();
  expectSameLinks(standing, findLinks(arm.reconstruction, RobotModel::parse(hung, "hung.urdf"), arm.angles, find));
}

/// How gravity on a link changes with the zero of a joint, by differences.
Eigen::Vector3d changeByZero(const RobotModel& robot, const std::vector<JointAngles>& angles,
                             const Eigen::Vector3d& up_w, std::size_t link, std::size_t joint) {
  constexpr double kStep = 1e-6;
  std::vector<double> zeros(robot.joints().size(), 0.0);
  zeros[joint] = kStep;
  const LinkGravity moved(robot, angles, up_w, zeros);
  return (moved.up(link, 0) - LinkGravity(robot, angles, up_w).up(link, 0)) / kStep;
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

// --- on a simulated robot

constexpr int kSimulatedRobots = test::kSlowBuild ? 1 : 20;

struct SimulatedLinksOptions {
  std::size_t poses = 8;
  bool motors = false;
};

/// Patches on the upper arm, the forearm and the hand of the demo robot.
SimulatedRobot simulatedArm(std::uint64_t seed, const SimulatedLinksOptions& options) {
  SimulatedRobotOptions robot;
  if (options.motors) robot.skin = SimulatedSkinOptions::robot();
  robot.seed = seed;
  robot.zero_offset_sigma_rad = 0.5 * kDegree;
  robot.mounts = demoMounts();
  PatchMount hand{"hand", {rotationFromRpy({0.2, 0.4, 1}), {0, 0.04, 0.05}}, "sheet:2x3", "plane"};
  robot.mounts.push_back(hand);
  return {builtInCellModel("hex-bma150"), RobotModel::read(demoRobotFile()), robot};
}

LinksTally tallySimulatedLinks(const SimulatedLinksOptions& options) {
  LinksTally tally;
  for (int seed = 1; seed <= kSimulatedRobots; ++seed) {
    SimulatedRobot robot = simulatedArm(static_cast<std::uint64_t>(seed), options);
    const SimulatedRobotSession simulated = simulateRobotSession(robot, options.poses);
    std::map<PoseId, JointAngles> angles;
    for (const SessionPose& pose : simulated.session.poses()) angles.emplace(pose.capture->id, pose.joint_angles);
    LinksTruth truth{{}, robot.zeroOffsets(), simulated.poses.front().up_w};
    for (const MountedPatch& patch : robot.patches()) {
      for (std::size_t k = 0; k < patch.cells.size(); ++k) {
        truth.cells[patch.cells[k]] = {patch.link, patch.T_l_u[k].R};
      }
    }
    tally.add(findLinks(*reconstruct(*simulated.session.snapshot()), robot.robot(), angles), truth);
  }
  return tally;
}

// Sensors of 60 mg, joints off by 0.5 degrees and a base tilted by 1 degree (1 sigma each), three patches.
TEST(LinksOnSimulatedRobot, AreRightAndStateHowWellTheyKnow) {
  const std::pair<std::string, SimulatedLinksOptions> cases[] = {
      {"still, 4 poses", {.poses = 4}}, {"still, 8 poses", {.poses = 8}}, {"motors, 8 poses", {.motors = true}}};
  for (const auto& [name, options] : cases) {
    const LinksTally tally = tallySimulatedLinks(options);
    EXPECT_EQ(tally.wrong, 0) << name;
    EXPECT_LE(tally.none, 0.01 * tally.patches) << name;
    if (test::kSlowBuild) continue;
    EXPECT_GT(meanOf(tally.turn_nees), 0.7) << name;
    EXPECT_LT(meanOf(tally.turn_nees), 1.5) << name;
    EXPECT_LE(median(tally.errors_rad), 1.2 * median(tally.stated_rad)) << name;
    EXPECT_LT(meanOf(tally.zero_nees), 1.8) << name;
    EXPECT_LT(meanOf(tally.tilt_nees), 1.8) << name;
  }
}

}  // namespace
}  // namespace hexoderm
