#include "hexoderm/robot/parts/parts.h"

#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/robot/parts/gravity_seen.h"
#include "hexoderm/util/error.h"
#include "tests/core/robot/parts/jointed_skins.h"
#include "tests/support/slow_build.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

using test::kSlowBuild;

double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values[values.size() / 2];
}

/// What became of simulated robots of two bodies with two patches on each, over many seeds.
struct Outcome {
  int right = 0;           ///< two parts of two patches, each on one body
  int wrong_together = 0;  ///< robots with a part that has patches of both bodies
  double nees = 0;         ///< of rotations inside parts, mean
  std::vector<double> errors_rad;
  std::vector<double> stated_rad;  ///< roots of the traces of the covariances
  int hinges = 0;
  int no_axis = 0;
  std::vector<double> axis_errors_rad;
  double axis_nees = 0;  ///< mean
};

class Trial {
 public:
  Trial(const JointedSkinsOptions& options, std::size_t poses)
      : skins_(options), result_(findParts(*reconstruct(*skins_.session(poses).snapshot()))) {}

  void addTo(Outcome& outcome) const {
    bool mixes = false;
    for (const Part& part : result_.parts) {
      for (const PatchOfPart& patch : part.patches) {
        if (skins_.bodyOf(patch.origin) != skins_.bodyOf(part.patches.front().origin)) {
          mixes = true;
        } else if (&patch != &part.patches.front()) {
          addRotation(part.patches.front(), patch, outcome);
        }
      }
    }
    outcome.wrong_together += mixes ? 1 : 0;
    if (mixes || result_.parts.size() != 2) return;
    ++outcome.right;
    addHinge(outcome);
  }

 private:
  void addRotation(const PatchOfPart& first, const PatchOfPart& patch, Outcome& outcome) const {
    const Eigen::Matrix3d truth = skins_.T_body_u(first.origin).R.transpose() * skins_.T_body_u(patch.origin).R;
    const Eigen::Vector3d e = logSO3(patch.R_part_o.transpose() * truth);
    const double nees = e.dot(patch.covariance.llt().solve(e)) / 3;
    const auto count = static_cast<double>(outcome.errors_rad.size());
    outcome.nees = (outcome.nees * count + nees) / (count + 1);
    outcome.errors_rad.push_back(e.norm());
    outcome.stated_rad.push_back(std::sqrt(patch.covariance.trace()));
  }

  void addHinge(Outcome& outcome) const {
    const PartRelation& relation = result_.relations.front();
    ASSERT_EQ(relation.movement, Movement::Apart);
    const Hinge& hinge = *relation.hinge;
    outcome.no_axis += hinge.knowledge == HingeKnowledge::NoAxis ? 1 : 0;
    if (hinge.knowledge != HingeKnowledge::Found) return;
    ++outcome.hinges;
    addAxis(hinge.a, result_.parts[relation.a], outcome);
    addAxis(hinge.b, result_.parts[relation.b], outcome);
  }

  void addAxis(const HingeAxis& axis, const Part& part, Outcome& outcome) const {
    const CellId frame = part.patches.front().origin;
    Eigen::Vector3d truth = skins_.T_body_u(frame).R.transpose() * skins_.axisIn(skins_.bodyOf(frame));
    if (truth.dot(axis.u) < 0) truth = -truth;
    const Eigen::Matrix<double, 3, 2> across = acrossBasis(axis.u);
    const Eigen::Vector2d e = across.transpose() * truth;
    const Eigen::Matrix2d C = across.transpose() * axis.covariance * across;
    const auto count = static_cast<double>(outcome.axis_errors_rad.size());
    outcome.axis_nees = (outcome.axis_nees * count + e.dot(C.llt().solve(e)) / 2) / (count + 1);
    outcome.axis_errors_rad.push_back(angleBetween(axis.u, truth));
  }

  mutable JointedSkins skins_;
  PartsResult result_;
};

Outcome outcomeOf(JointedSkinsOptions options, std::size_t poses, int seeds) {
  Outcome outcome;
  for (int seed = 1; seed <= seeds; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    Trial(options, poses).addTo(outcome);
  }
  return outcome;
}

void record(const std::string& name, const Outcome& outcome, int seeds) {
  ::testing::Test::RecordProperty(
      name, "right " + std::to_string(outcome.right) + " of " + std::to_string(seeds) + ", wrong together " +
                std::to_string(outcome.wrong_together) + ", rotation error, median " +
                std::to_string(toDegrees(medianOf(outcome.errors_rad))) + " deg, stated " +
                std::to_string(toDegrees(medianOf(outcome.stated_rad))) + ", NEES " + std::to_string(outcome.nees) +
                ", hinges " + std::to_string(outcome.hinges) + ", no axis " + std::to_string(outcome.no_axis) +
                ", axis error, median " + std::to_string(toDegrees(medianOf(outcome.axis_errors_rad))) + " deg, NEES " +
                std::to_string(outcome.axis_nees));
}

// Offsets of 60 mg, 100 readings a pose. In a hand that also turns the robot while it is read, with patches 0.2 m from
// each other; and on a robot that holds still.
TEST(Parts, FourPatchesOnTwoBodiesAreGrouped) {
  struct Case {
    std::string name;
    bool hand_held;
    std::size_t poses;
  };
  const int seeds = kSlowBuild ? 2 : 100;
  for (const Case& c : {Case{"hand, 4 poses", true, 4}, Case{"hand, 8 poses", true, 8},
                        Case{"still, 4 poses", false, 4}, Case{"still, 8 poses", false, 8}}) {
    JointedSkinsOptions options;
    options.hand_held = c.hand_held;
    const Outcome outcome = outcomeOf(options, c.poses, seeds);
    record(c.name, outcome, seeds);
    EXPECT_EQ(outcome.wrong_together, 0) << c.name;
    if (kSlowBuild) continue;
    EXPECT_GE(outcome.right, 0.99 * seeds) << c.name;
    EXPECT_LE(medianOf(outcome.errors_rad), 1.2 * medianOf(outcome.stated_rad)) << c.name;
    EXPECT_GE(outcome.nees, 0.7) << c.name;
    EXPECT_LE(outcome.nees, 1.5) << c.name;
    if (c.poses < 8) continue;
    EXPECT_GE(outcome.hinges, 0.95 * seeds) << c.name;
    EXPECT_LE(toDegrees(medianOf(outcome.axis_errors_rad)), 1.0) << c.name;
    EXPECT_LE(outcome.axis_nees, 1.5) << c.name;
  }
}

// A joint that stands still in all poses is not seen, and nothing but that is said.
TEST(Parts, AJointThatStandsStillCantBeSeen) {
  JointedSkinsOptions options;
  options.joint_range_rad = 0;
  options.hand_held = false;
  JointedSkins skins(options);
  const PartsResult result = findParts(*reconstruct(*skins.session(6).snapshot()));
  ASSERT_EQ(result.parts.size(), 1U);
  EXPECT_EQ(result.parts.front().patches.size(), 4U);
  EXPECT_TRUE(result.relations.empty());
  EXPECT_EQ(result.summary.english(),
            "All 4 patches move together, as far as these poses show: a joint that stood still in all of them can't be "
            "seen.");
  for (const PatchPair& pair : result.pairs) EXPECT_EQ(pair.movement, Movement::Together);
}

/// A session of the poses at these indices.
Session onlyPosesOf(const Session& session, const std::vector<std::size_t>& indices) {
  Session few(session.model(), session.neighbors());
  for (const std::size_t index : indices) few.addPose(session.poses()[index]);
  return few;
}

TEST(Parts, SaysWhatCantBeToldAndWhatWouldTell) {
  JointedSkinsOptions options;
  options.body_of_patch = {0, 1};
  options.patch = "sheet:1x1";  // no links that two poses may cast doubt on
  options.joint_range_rad = 0;
  options.hand_held = false;
  JointedSkins skins(options);
  const Session session = skins.session(6);

  // Up and upside down: scripted directions 1 and 4.
  const PartsResult line = findParts(*reconstruct(*onlyPosesOf(session, {0, 3}).snapshot()));
  ASSERT_EQ(line.relations.size(), 1U);
  EXPECT_EQ(line.relations[0].movement, Movement::CantTell);
  EXPECT_THAT(line.relations[0].why.english(), ::testing::HasSubstr("gravity came along one line in all poses"));
  EXPECT_EQ(line.relations[0].what_would_tell.english(),
            "Take poses in which the parts are tipped over by about 90 degrees.");
  EXPECT_FALSE(line.relations[0].hinge.has_value());

  const PartsResult two = findParts(*reconstruct(*onlyPosesOf(session, {0, 1}).snapshot()));
  ASSERT_EQ(two.relations.size(), 1U);
  EXPECT_EQ(two.relations[0].movement, Movement::CantTell);
  EXPECT_THAT(two.relations[0].why.english(), ::testing::HasSubstr("could have been moved without showing"));
  EXPECT_EQ(two.pairs.front().movement, Movement::CantTell);
  EXPECT_THAT(two.summary.english(), ::testing::HasSubstr("1 of the 1 pairs"));

  const PartsResult one = findParts(*reconstruct(*onlyPosesOf(session, {0}).snapshot()));
  EXPECT_THAT(one.relations[0].why.english(), ::testing::HasSubstr("fewer than two poses have readings of both"));
  const PartsResult none = findParts(*reconstruct(*onlyPosesOf(session, {}).snapshot()));
  EXPECT_EQ(none.summary.english(), "No patch saw gravity: there is nothing to compare.");
  EXPECT_EQ(none.not_compared.size(), 2U);
}

TEST(Parts, OnePatchHasNothingToBeComparedWith) {
  JointedSkinsOptions options;
  options.body_of_patch = {0};
  JointedSkins skins(options);
  const PartsResult result = findParts(*reconstruct(*skins.session(3).snapshot()));
  EXPECT_EQ(result.parts.size(), 1U);
  EXPECT_TRUE(result.pairs.empty());
  EXPECT_EQ(result.summary.english(), "There is one patch: nothing to compare it with.");
}

TEST(Parts, DoNotDependOnTheOrderOfThePoses) {
  JointedSkinsOptions options;
  options.hand_held = false;
  JointedSkins skins(options);
  const Session session = skins.session(6);
  const PartsResult one = findParts(*reconstruct(*session.snapshot()));
  const PartsResult other = findParts(*reconstruct(*onlyPosesOf(session, {3, 5, 1, 0, 4, 2}).snapshot()));
  ASSERT_EQ(one.parts.size(), other.parts.size());
  for (std::size_t k = 0; k < one.pairs.size(); ++k) {
    EXPECT_EQ(one.pairs[k].movement, other.pairs[k].movement);
    EXPECT_NEAR(one.pairs[k].chi_squared, other.pairs[k].chi_squared, 0.02 * one.pairs[k].chi_squared + 0.01);
  }
}

// More poses than are compared: those that differ most are taken, and the result is as good.
TEST(Parts, ManyPosesAreThinnedOut) {
  JointedSkinsOptions options;
  options.patch = "sheet:2x2";
  options.hand_held = false;
  options.sensor_frames = 10;
  JointedSkins skins(options);
  const PartsResult result = findParts(*reconstruct(*skins.session(kSlowBuild ? 52 : 120).snapshot()));
  EXPECT_EQ(result.parts.size(), 2U);
  for (const PatchPair& pair : result.pairs) EXPECT_EQ(pair.poses, PartsOptions().most_poses);
}

TEST(Parts, NeedTheCovarianceOfGravity) {
  JointedSkinsOptions options;
  JointedSkins skins(options);
  SolverOptions tree;
  tree.solver = Solver::Tree;
  const auto result = reconstruct(*skins.session(3).snapshot(), tree);
  EXPECT_THROW(static_cast<void>(findParts(*result)), InvalidArgument);
}

TEST(Parts, OptionsAreChecked) {
  PartsOptions options;
  options.false_alarm = 0;
  EXPECT_THROW(options.validate(), InvalidArgument);
  options = {};
  options.most_poses = 1;
  EXPECT_THROW(options.validate(), InvalidArgument);
  options = {};
  options.lever_m = -1;
  EXPECT_THROW(options.validate(), InvalidArgument);
  options = {};
  options.least_odds = 0;
  EXPECT_THROW(options.validate(), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
