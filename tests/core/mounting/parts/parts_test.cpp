#include "hexoderm/mounting/parts/parts.h"

#include "hexoderm/base/median.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/mounting/parts/gravity_draw.h"
#include "tests/core/mounting/parts/jointed_skins.h"
#include "tests/support/changed_session.h"
#include "tests/support/options.h"
#include "tests/support/slow_build.h"
#include "tests/support/solvers.h"

namespace hexoderm {
namespace {

using test::kSlowBuild;

/// What became of simulated robots of two bodies with two patches on each, over many seeds.
struct Outcome {
  int right = 0;                   ///< two parts of two patches, each on one body
  int wrong_together = 0;          ///< robots with a part that has patches of both bodies
  std::vector<double> errors_rad;  ///< of rotations inside parts
  std::vector<double> stated_rad;  ///< roots of the traces of the covariances
  std::vector<double> nees;
  int hinges = 0;
  std::vector<double> axis_errors_rad;
  std::vector<double> axis_nees;
};

void addTrial(const JointedSkinsOptions& options, std::size_t poses, Outcome& outcome) {
  JointedSkins skins(options);
  const PartsResult result = findParts(*reconstruct(*skins.session(poses).snapshot()));
  bool mixes = false;
  for (const Part& part : result.parts) {
    const PatchOfPart& first = part.patches.front();
    for (const PatchOfPart& patch : part.patches) {
      mixes = mixes || skins.bodyOf(patch.origin) != skins.bodyOf(first.origin);
      if (&patch == &first || skins.bodyOf(patch.origin) != skins.bodyOf(first.origin)) continue;
      const Eigen::Matrix3d truth = skins.T_body_u(first.origin).R.transpose() * skins.T_body_u(patch.origin).R;
      const Eigen::Vector3d e = logSO3(patch.R_part_o.transpose() * truth);
      outcome.nees.push_back(e.dot(patch.covariance.llt().solve(e)) / 3);
      outcome.errors_rad.push_back(e.norm());
      outcome.stated_rad.push_back(std::sqrt(patch.covariance.trace()));
    }
  }
  outcome.wrong_together += mixes ? 1 : 0;
  if (mixes || result.parts.size() != 2) return;
  ++outcome.right;
  const PartRelation& relation = result.relations.front();
  ASSERT_EQ(relation.movement, Movement::Apart);
  if (relation.hinge->knowledge != HingeKnowledge::Found) return;
  ++outcome.hinges;
  for (const auto& [axis, part] :
       {std::pair(relation.hinge->a, relation.a), std::pair(relation.hinge->b, relation.b)}) {
    const CellId frame = result.parts[part].patches.front().origin;
    const Eigen::Vector3d truth = skins.T_body_u(frame).R.transpose() * skins.axisIn(skins.bodyOf(frame));
    outcome.axis_nees.push_back(neesOfAxis(axis.u, axis.covariance, truth));
    outcome.axis_errors_rad.push_back(std::asin(std::min(1.0, axis.u.cross(truth).norm())));
  }
}

// Offsets of 60 mg, 100 readings a pose. In a hand that also turns the robot while it is read, with patches 0.2 m from
// each other; and on a robot that holds still.
TEST(Parts, FourPatchesOnTwoBodiesAreGrouped) {
  const int seeds = kSlowBuild ? 2 : 100;
  for (const auto& [hand_held, poses] :
       {std::pair(true, 4U), std::pair(true, 8U), std::pair(false, 4U), std::pair(false, 8U)}) {
    SCOPED_TRACE((hand_held ? "hand, " : "still, ") + std::to_string(poses) + " poses");
    JointedSkinsOptions options{.hand_held = hand_held};
    Outcome outcome;
    for (int seed = 1; seed <= seeds; ++seed) {
      options.seed = static_cast<std::uint64_t>(seed);
      addTrial(options, poses, outcome);
    }
    EXPECT_EQ(outcome.wrong_together, 0);
    if (kSlowBuild) continue;
    EXPECT_GE(outcome.right, 0.99 * seeds);
    EXPECT_LE(median(outcome.errors_rad), 1.2 * median(outcome.stated_rad));
    EXPECT_GE(meanOf(outcome.nees), 0.7);
    EXPECT_LE(meanOf(outcome.nees), 1.5);
    if (poses < 8) continue;
    EXPECT_GE(outcome.hinges, 0.95 * seeds);
    EXPECT_LE(toDegrees(median(outcome.axis_errors_rad)), 1.0);
    EXPECT_LE(meanOf(outcome.axis_nees), 1.5);
  }
}

PartsResult partsOf(const Session& session) { return findParts(*reconstruct(*session.snapshot())); }
PartsResult partsOf(const JointedSkinsOptions& options, std::size_t poses) {
  return partsOf(JointedSkins(options).session(poses));
}

// A joint that stands still in all poses is not seen, and nothing but that is said.
TEST(Parts, AJointThatStandsStillCantBeSeen) {
  const PartsResult result = partsOf({.hand_held = false, .joint_range_rad = 0}, 6);
  ASSERT_EQ(result.parts.size(), 1U);
  EXPECT_EQ(result.parts.front().patches.size(), 4U);
  EXPECT_TRUE(result.relations.empty());
  EXPECT_EQ(result.summary.english(),
            "All 4 patches move together, as far as these poses show: a joint that stood still in all of them can't be "
            "seen.");
  for (const PatchPair& pair : result.pairs) EXPECT_EQ(pair.movement, Movement::Together);
}

TEST(Parts, SaysWhatCantBeToldAndWhatWouldTell) {
  // One cell each: no links that two poses may cast doubt on.
  const Session session =
      JointedSkins(
          JointedSkinsOptions{.body_of_patch = {0, 1}, .patch = "sheet:1x1", .hand_held = false, .joint_range_rad = 0})
          .session(6);

  // Up and upside down: scripted directions 1 and 4.
  const PartsResult line = partsOf(onlyPosesOf(session, {0, 3}));
  ASSERT_EQ(line.relations.size(), 1U);
  EXPECT_EQ(line.relations[0].movement, Movement::CantTell);
  EXPECT_THAT(line.relations[0].why.english(), ::testing::HasSubstr("gravity came along one line in all poses"));
  EXPECT_EQ(line.relations[0].what_would_tell.english(),
            "Take poses in which the parts are tipped over by about 90 degrees.");
  EXPECT_FALSE(line.relations[0].hinge.has_value());

  const PartsResult two = partsOf(onlyPosesOf(session, {0, 1}));
  ASSERT_EQ(two.relations.size(), 1U);
  EXPECT_EQ(two.relations[0].movement, Movement::CantTell);
  EXPECT_THAT(two.relations[0].why.english(), ::testing::HasSubstr("could have been moved without showing"));
  EXPECT_EQ(two.pairs.front().movement, Movement::CantTell);
  EXPECT_THAT(two.summary.english(), ::testing::HasSubstr("1 of the 1 pairs"));

  const PartsResult one = partsOf(onlyPosesOf(session, {0}));
  EXPECT_THAT(one.relations[0].why.english(), ::testing::HasSubstr("fewer than two poses have readings of both"));
  const PartsResult none = partsOf(onlyPosesOf(session, {}));
  EXPECT_EQ(none.summary.english(), "No patch saw gravity: there is nothing to compare.");
  EXPECT_EQ(none.not_compared.size(), 2U);
}

TEST(Parts, OnePatchHasNothingToBeComparedWith) {
  const PartsResult result = partsOf({.body_of_patch = {0}}, 3);
  EXPECT_EQ(result.parts.size(), 1U);
  EXPECT_TRUE(result.pairs.empty());
  EXPECT_EQ(result.summary.english(), "There is one patch: nothing to compare it with.");
}

TEST(Parts, DoNotDependOnTheOrderOfThePoses) {
  const Session session = JointedSkins(JointedSkinsOptions{.hand_held = false}).session(6);
  const PartsResult one = partsOf(session);
  const PartsResult other = partsOf(onlyPosesOf(session, {3, 5, 1, 0, 4, 2}));
  ASSERT_EQ(one.parts.size(), other.parts.size());
  for (std::size_t k = 0; k < one.pairs.size(); ++k) {
    EXPECT_EQ(one.pairs[k].movement, other.pairs[k].movement);
    EXPECT_NEAR(one.pairs[k].chi_squared, other.pairs[k].chi_squared, 0.02 * one.pairs[k].chi_squared + 0.01);
  }
}

// More poses than are compared: those that differ most are taken, and the result is as good.
TEST(Parts, ManyPosesAreThinnedOut) {
  const PartsResult result =
      partsOf({.patch = "sheet:2x2", .hand_held = false, .sensor_frames = 10}, kSlowBuild ? 52 : 120);
  EXPECT_EQ(result.parts.size(), 2U);
  for (const PatchPair& pair : result.pairs) EXPECT_EQ(pair.poses, PartsOptions().most_poses);
}

TEST(Parts, NeedTheCovarianceOfGravity) {
  const auto result = reconstruct(*JointedSkins(JointedSkinsOptions{}).session(3).snapshot(), test::by(Solver::Tree));
  EXPECT_THROW(static_cast<void>(findParts(*result)), InvalidArgument);
}

TEST(Parts, OptionsAreChecked) {
  for (const PartsOptions& options :
       {test::with(&PartsOptions::false_alarm, 0), test::with(&PartsOptions::most_poses, 1),
        test::with(&PartsOptions::lever_m, -1), test::with(&PartsOptions::least_odds, 0)}) {
    EXPECT_THROW(options.validate(), InvalidArgument);
  }
}

}  // namespace
}  // namespace hexoderm
