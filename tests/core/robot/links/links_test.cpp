#include "hexoderm/robot/links/links.h"

#include "hexoderm/util/error.h"
#include "tests/core/robot/links/drawn_links.h"
#include "tests/support/error_matchers.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>

namespace hexoderm {
namespace {

using test::messageOf;
using test::saysAll;
using ::testing::Contains;
using ::testing::HasSubstr;

std::vector<std::string> namesOf(const LinkCandidate& candidate) {
  std::vector<std::string> names;
  for (const PatchTurn& turn : candidate.links) names.push_back(turn.link);
  return names;
}
std::vector<std::string> findingsOf(const LinksResult& result) {
  std::vector<std::string> texts;
  for (const Message& finding : result.findings) texts.push_back(finding.english());
  return texts;
}
const JointZero* zeroOf(const LinksResult& result, const std::string& joint) {
  for (const JointZero& zero : result.robot->zeros) {
    if (zero.joint == joint) return &zero;
  }
  return nullptr;
}
Eigen::Vector3d errorOf(const PatchTurn& turn, const Eigen::Matrix3d& truth) {
  return logSO3(turn.R_l_o.transpose() * truth);
}

TEST(Links, WithoutErrorsAreExact) {
  DrawnArmOptions options;
  options.error_scale = 0;
  options.zero_sigma_rad = 0;
  options.tilt_sigma_rad = 0;
  options.links = {"l3", "l6", "l4_cover"};
  const DrawnArm arm(options);
  const LinksResult result = arm.find();
  ASSERT_EQ(result.patches.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const PatchLinks& patch = result.patches[k];
    ASSERT_TRUE(patch.placed.has_value()) << patch.why;
    EXPECT_NEAR(patch.candidates.front().chi_squared, 0, 1e-12);
    for (const PatchTurn& turn : patch.candidates.front().links) {
      if (turn.link == options.links[k]) {
        EXPECT_LT(errorOf(turn, arm.R_l_o[k]).norm(), 1e-9) << turn.link;
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

/// Over seeds: what is claimed, and how it agrees with the truth.
struct Tally {
  int patches = 0;
  int right = 0;        ///< the right link, alone or with links that are fixed to it
  int among = 0;        ///< among the candidates
  int wrong_alone = 0;  ///< candidates without the right link
  double nees = 0;      ///< of turns, sum
  int turns = 0;
  double zero_nees = 0;  ///< of zeros that are shown, sum
  int zeros = 0;
  double tilt_nees = 0;
  int tilts = 0;
  std::vector<double> errors_rad;
  std::vector<double> stated_rad;
};

void tally(const DrawnArm& arm, const DrawnArmOptions& options, const LinksResult& result, Tally& sum) {
  for (std::size_t k = 0; k < result.patches.size(); ++k) {
    const PatchLinks& patch = result.patches[k];
    ++sum.patches;
    bool is_among = false;
    for (const LinkCandidate& candidate : patch.candidates) {
      const std::vector<std::string> names = namesOf(candidate);
      is_among = is_among || std::ranges::find(names, options.links[k]) != names.end();
    }
    sum.among += is_among ? 1 : 0;
    sum.wrong_alone += !is_among && !patch.candidates.empty() ? 1 : 0;
    if (!is_among || !patch.placed) continue;
    ++sum.right;
    for (const PatchTurn& turn : patch.candidates.front().links) {
      if (turn.link != options.links[k]) continue;
      const Eigen::Vector3d e = errorOf(turn, arm.R_l_o[k]);
      sum.nees += e.dot(turn.covariance.llt().solve(e)) / 3;
      ++sum.turns;
      sum.errors_rad.push_back(e.norm());
      sum.stated_rad.push_back(std::sqrt(turn.covariance.trace()));
    }
  }
  if (!result.robot) return;
  for (const JointZero& zero : result.robot->zeros) {
    if (!zero.shown) continue;
    sum.zero_nees += std::pow((zero.zero_rad - arm.zeros.at(zero.joint)) / zero.sigma_rad, 2);
    ++sum.zeros;
  }
  const Eigen::Matrix<double, 3, 2> across = acrossBasis(result.robot->up_w);
  const Eigen::Vector2d e = across.transpose() * arm.up_w;
  const Eigen::Matrix2d C = across.transpose() * result.robot->up_covariance * across;
  sum.tilt_nees += e.dot(C.llt().solve(e)) / 2;
  ++sum.tilts;
}

double medianAngleOf(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values[values.size() / 2];
}

void record(const std::string& name, const Tally& sum) {
  ::testing::Test::RecordProperty(
      name, "right " + std::to_string(sum.right) + ", among " + std::to_string(sum.among) + " of " +
                std::to_string(sum.patches) + ", wrong alone " + std::to_string(sum.wrong_alone) + ", NEES " +
                std::to_string(sum.nees / sum.turns) + ", error, median " +
                std::to_string(toDegrees(medianAngleOf(sum.errors_rad))) + " deg, stated " +
                std::to_string(toDegrees(medianAngleOf(sum.stated_rad))) + ", zeros " + std::to_string(sum.zeros) +
                ", NEES " + std::to_string(sum.zero_nees / sum.zeros) + ", tilt NEES " +
                std::to_string(sum.tilt_nees / sum.tilts));
}

#ifdef NDEBUG
constexpr int kSeeds = 100;
#else
constexpr int kSeeds = 5;
#endif

// Errors as stated: the right link, and uncertainties that agree with the truth.
TEST(Links, AreRightAndStateHowWellTheyKnow) {
  for (const std::size_t poses : {4U, 8U}) {
    Tally sum;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      DrawnArmOptions options;
      options.seed = static_cast<std::uint64_t>(seed);
      options.poses = poses;
      options.links = {"l2", "l3", "l4", "l6"};
      const DrawnArm arm(options);
      tally(arm, options, arm.find(), sum);
    }
    record(std::to_string(poses) + " poses", sum);
    EXPECT_EQ(sum.wrong_alone, 0);
    EXPECT_GE(sum.among, 0.99 * sum.patches);
    if (kSeeds < 100) continue;
    EXPECT_GT(sum.nees / sum.turns, 0.7);
    EXPECT_LT(sum.nees / sum.turns, 1.5);
    EXPECT_LE(medianAngleOf(sum.errors_rad), 1.2 * medianAngleOf(sum.stated_rad));
    EXPECT_GT(sum.zeros, 0);
    EXPECT_LT(sum.zero_nees / sum.zeros, 1.5);
    EXPECT_LT(sum.tilt_nees / sum.tilts, 1.5);
  }
}

// Four times what the prior says: links are still found, and zeros within their stated sigma.
TEST(Links, ZerosOfTwoDegreesAreFound) {
  Tally sum;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    DrawnArmOptions options;
    options.seed = static_cast<std::uint64_t>(1000 + seed);
    options.poses = 8;
    options.links = {"l2", "l4", "l6"};
    options.zero_sigma_rad = 2 * kDegree;
    const DrawnArm arm(options);
    tally(arm, options, arm.find(), sum);
  }
  record("zeros of 2 degrees", sum);
  EXPECT_EQ(sum.wrong_alone, 0);
  EXPECT_GE(sum.among, 0.99 * sum.patches);
  if (kSeeds < 100) return;
  EXPECT_GT(sum.zeros, 0);
  EXPECT_GT(sum.zero_nees / sum.zeros, 0.5);
  EXPECT_LT(sum.zero_nees / sum.zeros, 1.5);
  EXPECT_LT(sum.nees / sum.turns, 1.5);
}

TEST(Links, ALargeZeroIsSaid) {
  DrawnArmOptions options;
  options.links = {"l2", "l4", "l6"};
  options.poses = 12;
  options.zero_sigma_rad = 0;
  DrawnArm arm(options);
  for (auto& [pose, angles] : arm.angles) angles.positions["j4"] -= 3 * kDegree;
  const LinksResult result = arm.find();
  EXPECT_THAT(findingsOf(result), Contains(HasSubstr("The zero of joint j4 seems to be off")));
  const JointZero* zero = zeroOf(result, "j4");
  ASSERT_NE(zero, nullptr);
  EXPECT_TRUE(zero->shown);
  EXPECT_NEAR(zero->zero_rad, 3 * kDegree, 3 * zero->sigma_rad);
  LinksOptions exact;
  exact.test_lever_m = 0;
  exact.joint_zeros = false;
  for (const JointZero& none : arm.find(exact).robot.value_or(RobotEstimate()).zeros) EXPECT_EQ(none.zero_rad, 0);
}

// --- what can't be told

TEST(Links, OnePoseFitsAnyLink) {
  DrawnArmOptions options;
  options.poses = 1;
  const LinksResult result = DrawnArm(options).find();
  const PatchLinks& patch = result.patches.front();
  EXPECT_FALSE(patch.placed.has_value());
  ASSERT_EQ(patch.candidates.size(), 1U);
  EXPECT_EQ(patch.candidates.front().links.size(), 9U);
  EXPECT_THAT(patch.why.english(), HasSubstr("can't be told from one pose"));
  ASSERT_TRUE(patch.open_axis_l.has_value());
  EXPECT_FALSE(result.robot.has_value());
}

TEST(Links, WithAJointBetweenThatNeverMovedAreOneCandidate) {
  DrawnArmOptions options;
  options.links = {"l5"};
  options.poses = 8;
  DrawnArm still(options);
  for (auto& [pose, angles] : still.angles) angles.positions["j6"] = 0.4;
  LinksOptions find;
  find.test_lever_m = 0;
  const LinksResult result = still.find(find);
  const PatchLinks& patch = result.patches.front();
  ASSERT_EQ(patch.candidates.size(), 1U) << patch.why;
  EXPECT_THAT(namesOf(patch.candidates.front()), ::testing::ElementsAre("l5", "l6", "finger"));
  EXPECT_FALSE(patch.placed.has_value()) << "the operator picks";
  EXPECT_THAT(patch.why.english(), HasSubstr("which these poses can't tell apart: l5, l6 and finger"));
  EXPECT_THAT(patch.what_would_tell.english(), HasSubstr("from pose to pose, with their axes level: j6"));

  LinksOptions picked = find;
  picked.chosen[result.patches.front().origin] = "l6";
  const LinksResult placed = still.find(picked);
  ASSERT_TRUE(placed.patches.front().placed.has_value());
  EXPECT_EQ(placed.patches.front().placed->link, "l6");
  EXPECT_TRUE(placed.patches.front().chosen);
}

TEST(Links, OnTheBaseTheTurnAboutTheVerticalStaysOpen) {
  DrawnArmOptions options;
  options.links = {"base"};
  const LinksResult result = DrawnArm(options).find();
  const PatchLinks& patch = result.patches.front();
  ASSERT_EQ(patch.candidates.size(), 1U);
  EXPECT_EQ(namesOf(patch.candidates.front()), (std::vector<std::string>{"base", "l1"})) << "j1 is upright";
  ASSERT_TRUE(patch.open_axis_l.has_value());
  EXPECT_LT(angleBetween(patch.open_axis_l->cwiseAbs(), Eigen::Vector3d::UnitZ()), 5 * kDegree);
  EXPECT_THAT(patch.why.english(), HasSubstr("about one axis is not determined"));
  EXPECT_THAT(patch.what_would_tell.english(), HasSubstr("with their axes level: j1"));
  LinksOptions put;
  put.test_lever_m = 0;
  put.chosen[patch.origin] = "base";
  EXPECT_THAT(DrawnArm(options).find(put).patches.front().what_would_tell.english(),
              HasSubstr("No joint moves link base"));
}

// How the base is tilted and how the patch is turned about the vertical can't be told apart there, however much the
// base seems to be tilted.
TEST(Links, OnTheBaseATiltSaysNothingOfTheTurnAboutTheVertical) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    DrawnArmOptions options;
    options.links = {"l1"};
    options.poses = 8;
    options.seed = seed;
    options.tilt_sigma_rad = 3 * kDegree;
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
  DrawnArmOptions options;
  options.links = {"l6"};
  options.range_rad = 0.0005;
  const LinksResult result = DrawnArm(options).find();
  const PatchLinks& patch = result.patches.front();
  ASSERT_EQ(patch.candidates.size(), 1U) << patch.why;
  EXPECT_EQ(patch.candidates.front().links.size(), 9U);
  ASSERT_TRUE(patch.open_axis_l.has_value());
  EXPECT_THAT(patch.why.english(), HasSubstr("gravity came along one line in all poses"));
  EXPECT_FALSE(patch.what_would_tell.empty());
}

TEST(Links, APatchOnNoLinkIsOnNone) {
  DrawnArmOptions options;
  options.poses = 8;
  options.links = {"l3", "l6"};
  DrawnArm arm(options);
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

  LinksOptions by_hand;
  by_hand.test_lever_m = 0;
  by_hand.chosen[lost.origin] = "l5";
  const LinksResult forced = arm.find(by_hand);
  ASSERT_TRUE(forced.patches[1].placed.has_value()) << "the operator's word counts";
  EXPECT_THAT(findingsOf(forced), Contains(HasSubstr("was put on link l5, which doesn't fit")));
}

// --- mistakes in the angles

TEST(Links, DegreesReadAsRadiansAreNoticed) {
  DrawnArmOptions options;
  options.poses = 8;
  options.range_rad = 1.2;
  DrawnArm arm(options);
  for (auto& [pose, angles] : arm.angles) {
    for (auto& [joint, angle] : angles.positions) angle = toDegrees(angle);
  }
  EXPECT_THAT(findingsOf(arm.find()),
              Contains(HasSubstr("probably degrees that were read as rad: as degrees they fit")));

  DrawnArm other(options);
  for (auto& [pose, angles] : other.angles) {
    for (auto& [joint, angle] : angles.positions) angle *= kDegree;
  }
  EXPECT_THAT(findingsOf(other.find()), Contains(HasSubstr("probably rad that were read as degrees")));
}

TEST(Links, AJointThatCountsTheOtherWayRoundIsNamed) {
  DrawnArmOptions options;
  options.poses = 8;
  options.links = {"l6"};
  DrawnArm arm(options);
  for (auto& [pose, angles] : arm.angles) angles.positions["j4"] *= -1;
  const LinksResult result = arm.find();
  EXPECT_TRUE(result.patches.front().candidates.empty());
  EXPECT_THAT(findingsOf(result), Contains(HasSubstr("Joint j4 seems to count its angle the other way round")));
}

TEST(Links, AJointWhoseZeroIsFarOffIsNamed) {
  DrawnArmOptions options;
  options.poses = 8;
  options.links = {"l6"};
  DrawnArm arm(options);
  for (auto& [pose, angles] : arm.angles) angles.positions["j4"] -= kPi / 2;
  const LinksResult result = arm.find();
  EXPECT_TRUE(result.patches.front().candidates.empty());
  EXPECT_THAT(findingsOf(result), Contains(HasSubstr("The zero of joint j4 seems to be off by about")));
}

TEST(Links, AnglesThatAreOffByOnePoseAreSaid) {
  DrawnArmOptions options;
  options.poses = 8;
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
  DrawnArmOptions options;
  options.poses = 8;
  DrawnArm arm(options);
  arm.angles[PoseId(3)].positions["j2"] += 1;
  arm.angles[PoseId(3)].positions["j4"] -= 1;
  EXPECT_THAT(findingsOf(arm.find()), Contains(HasSubstr("Pose 3 doesn't go with the others")));
}

TEST(Links, ABaseThatHangsOrMovedIsSaid) {
  DrawnArmOptions options;
  options.poses = 8;
  const DrawnArm arm(options);
  LinksOptions hanging;
  hanging.test_lever_m = 0;
  hanging.up_w = -Eigen::Vector3d::UnitZ();
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
  DrawnArmOptions options;
  options.poses = 8;
  options.links = {"l3"};
  DrawnArm arm(options);
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

TEST(Links, BadInputIsRefusedInWords) {
  const DrawnArm arm(DrawnArmOptions{});
  LinksOptions options;
  options.chosen[CellId(100)] = "l33";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { static_cast<void>(arm.find(options)); }), HasSubstr("l33"));
  options.chosen.clear();
  options.chosen[CellId(7)] = "l3";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { static_cast<void>(arm.find(options)); }), HasSubstr("no cell 7"));

  DrawnArm filed(DrawnArmOptions{});
  for (PatchReconstruction& patch : filed.reconstruction.patches) patch.gravity_covariance = nullptr;
  EXPECT_THAT(messageOf<InvalidArgument>([&] { static_cast<void>(filed.find()); }), HasSubstr("just solved"));

  for (const auto& spoil : std::vector<std::function<void(LinksOptions&)>>{
           [](LinksOptions& o) { o.up_w.setZero(); }, [](LinksOptions& o) { o.false_alarm = 0; },
           [](LinksOptions& o) { o.zero_sigma_rad = -1; }, [](LinksOptions& o) { o.tilt_sigma_rad = -1; },
           [](LinksOptions& o) { o.lever_m = -1; }, [](LinksOptions& o) { o.test_lever_m = -1; },
           [](LinksOptions& o) { o.most_poses = 1; }}) {
    LinksOptions spoiled;
    spoil(spoiled);
    EXPECT_THROW(spoiled.validate(), InvalidArgument);
  }
}

// --- invariances

TEST(Links, DoNotDependOnThePatchsFrame) {
  DrawnArmOptions options;
  const DrawnArm arm(options);
  DrawnArm turned(options);
  const Eigen::Matrix3d Q = expSO3({0.7, -1.1, 2});
  for (PatchReconstruction& patch : turned.reconstruction.patches) {
    GravitySeen seen;
    for (const GravityDirection& gravity : patch.gravity) {
      seen.poses.push_back(gravity.pose);
      seen.up.emplace_back(Q.transpose() * gravity.g_o);
    }
    const auto rows = static_cast<Eigen::Index>(2 * seen.size());
    seen.covariance.resize(rows, rows);
    for (std::size_t a = 0; a < seen.size(); ++a) {
      for (std::size_t b = 0; b < seen.size(); ++b) {
        seen.covariance.block<2, 2>(static_cast<Eigen::Index>(2 * a), static_cast<Eigen::Index>(2 * b)) =
            acrossBasis(seen.up[a]).transpose() * Q.transpose() * patch.gravity_covariance->forces(a, b) * Q *
            acrossBasis(seen.up[b]);
      }
    }
    patch = patchThatSaw(seen, patch.id.value());
  }
  const LinksResult before = arm.find();
  const LinksResult after = turned.find();
  for (std::size_t k = 0; k < before.patches.size(); ++k) {
    ASSERT_TRUE(before.patches[k].placed && after.patches[k].placed);
    EXPECT_EQ(before.patches[k].placed->link, after.patches[k].placed->link);
    EXPECT_NEAR(before.patches[k].candidates[0].chi_squared, after.patches[k].candidates[0].chi_squared, 1e-6);
    EXPECT_LT((before.patches[k].placed->R_l_o * Q - after.patches[k].placed->R_l_o).norm(), 1e-6);
    EXPECT_LT((Q.transpose() * before.patches[k].placed->covariance * Q - after.patches[k].placed->covariance).norm(),
              1e-6);
  }
}

/// The same robot, with links and joints called otherwise and written in the opposite order.
std::string renamedArm() {
  const std::string urdf = armUrdf();
  std::vector<std::string> elements;
  const std::size_t begin = urdf.find("<link");
  for (std::size_t at = begin; at < urdf.rfind("</robot>");) {
    const std::size_t next_link = urdf.find("<link name", at + 1);
    const std::size_t next_joint = urdf.find("<joint name", at + 1);
    const std::size_t end = std::min({next_link, next_joint, urdf.rfind("</robot>")});
    elements.push_back(urdf.substr(at, end - at));
    at = end;
  }
  std::string text = urdf.substr(0, begin);
  for (auto element = elements.rbegin(); element != elements.rend(); ++element) text += *element;
  text += "</robot>";
  // "l3" becomes "zz_l3_x", which is sorted otherwise among the others.
  for (const std::string name : {"base", "l1", "l2", "l3", "l4", "l4_cover", "l5", "l6", "finger"}) {
    const std::string quoted = "\"" + name + "\"";
    const std::string other = std::string("\"") + static_cast<char>('z' - name.back() % 20) + "_" + name + "\"";
    for (std::size_t at = text.find(quoted); at != std::string::npos; at = text.find(quoted, at + other.size())) {
      text.replace(at, quoted.size(), other);
    }
  }
  return text;
}

TEST(Links, DoNotDependOnNamesAndOrderOfTheFile) {
  DrawnArmOptions options;
  const DrawnArm arm(options);
  const RobotModel renamed = RobotModel::parse(renamedArm(), "renamed.urdf");
  LinksOptions find;
  find.test_lever_m = 0;
  const LinksResult before = arm.find(find);
  const LinksResult after = findLinks(arm.reconstruction, renamed, arm.angles, find);
  for (std::size_t k = 0; k < before.patches.size(); ++k) {
    ASSERT_TRUE(before.patches[k].placed && after.patches[k].placed);
    EXPECT_THAT(after.patches[k].placed->link, ::testing::EndsWith("_" + before.patches[k].placed->link));
    EXPECT_LT((before.patches[k].placed->R_l_o - after.patches[k].placed->R_l_o).norm(), 1e-6);
    ASSERT_EQ(before.patches[k].candidates.size(), after.patches[k].candidates.size());
  }
  EXPECT_NEAR(before.robot->chi_squared, after.robot->chi_squared, 1e-6);
}

// A robot that hangs from the ceiling.
TEST(Links, TheBaseMayStandOtherwise) {
  const DrawnArm arm(DrawnArmOptions{});
  std::string hung = armUrdf();
  const std::string first = "<origin xyz=\"0 0 0.3\"/>";
  hung.replace(hung.find(first), first.size(), "<origin xyz=\"0 0 0.3\" rpy=\"3.141592653589793 0 0\"/>");
  LinksOptions find;
  find.test_lever_m = 0;
  const LinksResult standing = arm.find(find);
  find.up_w = -2 * Eigen::Vector3d::UnitZ();
  const LinksResult hanging = findLinks(arm.reconstruction, RobotModel::parse(hung, "hung.urdf"), arm.angles, find);
  for (std::size_t k = 0; k < standing.patches.size(); ++k) {
    ASSERT_TRUE(standing.patches[k].placed && hanging.patches[k].placed);
    EXPECT_EQ(standing.patches[k].placed->link, hanging.patches[k].placed->link);
    EXPECT_LT((standing.patches[k].placed->R_l_o - hanging.patches[k].placed->R_l_o).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace hexoderm
