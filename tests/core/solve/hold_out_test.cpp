#include "hexoderm/solve/hold_out.h"

#include "hexoderm/base/units.h"
#include "tests/support/changed_session.h"
#include "tests/support/matchers.h"
#include "tests/support/options.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

#include <ostream>

namespace hexoderm {
namespace {

using ::testing::Lt;

/// The session with the readings of its third pose changed.
Session inThirdPose(const Session& session, const std::function<void(GravitySample&)>& change) {
  return changed(session, [&](std::size_t pose, GravitySample& sample) {
    if (pose == 2) change(sample);
  });
}

TEST(HoldOut, ExactReadingsAreForetoldExactly) {
  std::vector<Eigen::Vector3d> ups = orthogonalUps(6);
  ups[3] = expSO3({0.3, 0.8, -0.2}) * ups[3];  // like none of the others
  const Session session = bentX17().session(ups);
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(4));
  EXPECT_EQ(result.outcome, HoldOutOutcome::Evaluated);
  EXPECT_EQ(result.other_poses, 5U);
  ASSERT_THAT(result.cells, SizeIs(17));
  EXPECT_THAT(result.links, SizeIs(16));
  // Priors pull a little.
  EXPECT_THAT(result.cells, Each(Field(&HoldOutCell::error_rad, Lt(0.02 * kDegree))));
  EXPECT_EQ(result.agreement, HoldOutAgreement::AsStated);
  EXPECT_GT(result.expected_rms_rad, 0.05 * kDegree) << "what is stated does not know that nothing is wrong";
}

/// A patch, whether a hand holds it, and poses.
class HoldOutOf : public testing::TestWithParam<std::tuple<const char*, bool, std::size_t>> {
 protected:
  /// Of what is observed to what is expected, in ascending order; the pose that is held out changes with the seed.
  struct Ratios {
    std::vector<double> rms;
    std::vector<double> links;
    std::vector<double> worst_cell;
    std::size_t as_stated = 0;
  };
  static Ratios overSeeds(std::uint64_t seeds) {
    Ratios ratios;
    const auto& [patch, hand_held, poses] = GetParam();
    const char* const surface = std::string_view(patch) == "x17" ? "" : "cylinder:r=0.1";
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      SimulatedSkinOptions options = test::skinOptions(patch, surface, seed);
      options.hand_held = hand_held;
      options.drifts_after = poses;  // offsets are as unstable as the model says
      const Session session = test::simulatedSession(options, poses);
      const PoseId held_out(static_cast<std::uint32_t>(1 + seed % poses));
      const HoldOutResult result = evaluateHoldOut(*session.snapshot(), held_out);
      EXPECT_EQ(result.outcome, HoldOutOutcome::Evaluated);
      ratios.rms.push_back(result.rms_rad / result.expected_rms_rad);
      double squares = 0;
      for (const HoldOutLink& link : result.links) squares += std::pow(link.error_rad / link.expected_rad, 2);
      ratios.links.push_back(std::sqrt(squares / static_cast<double>(result.links.size())));
      double worst = 0;
      for (const HoldOutCell& cell : result.cells) worst = std::max(worst, cell.error_rad / cell.expected_rad);
      ratios.worst_cell.push_back(worst);
      if (result.agreement == HoldOutAgreement::AsStated) ++ratios.as_stated;
    }
    for (std::vector<double>* each : {&ratios.rms, &ratios.links, &ratios.worst_cell}) std::ranges::sort(*each);
    return ratios;
  }
};

TEST_P(HoldOutOf, ErrsAsMuchAsExpectedInTheMedianOverSeeds) {
  constexpr std::size_t kSkins = 21;
  const Ratios ratios = overSeeds(kSkins);
  const double median = ratios.rms[kSkins / 2];
  EXPECT_GT(median, 0.87);
  EXPECT_LT(median, 1.13);
  const double of_links = ratios.links[kSkins / 2];
  EXPECT_GT(of_links, 0.85);
  EXPECT_LT(of_links, 1.15);
  // No seed is far from it, and no cell by itself: nothing is wrong with any of these skins.
  EXPECT_GT(ratios.rms.front(), 0.6);
  EXPECT_LT(ratios.worst_cell.back(), 4);
  EXPECT_GE(ratios.as_stated, kSkins - 1);
}

INSTANTIATE_TEST_SUITE_P(Skins, HoldOutOf,
                         testing::Combine(testing::Values("x17", "sheet:10x10"), testing::Bool(),
                                          testing::Values(4U, 6U, 8U)));

TEST(HoldOut, ACellThatReadsOtherwiseInThePoseStandsOut) {
  const Session session =
      inThirdPose(test::simulatedSession(test::skinOptions("x17", "", 3), 6), [](GravitySample& sample) {
        if (sample.cell == CellId(8)) sample.mean_g = expSO3({20 * kDegree, 0, 20 * kDegree}) * sample.mean_g;
      });
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(3));
  const auto worst = std::ranges::max_element(result.cells, {}, &HoldOutCell::error_rad);
  ASSERT_NE(worst, result.cells.end());
  EXPECT_EQ(worst->cell, CellId(8));
  EXPECT_GT(worst->error_rad, 5 * worst->expected_rad);
  EXPECT_EQ(result.agreement, HoldOutAgreement::FarWorse);
  // Its two links have the largest errors of all links.
  std::vector<HoldOutLink> links = result.links;
  std::ranges::sort(links, std::ranges::greater(), &HoldOutLink::error_rad);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(links[k].source.cell == CellId(8) || links[k].target.cell == CellId(8)) << k;
  }
}

TEST(HoldOut, AnOffsetThatJumpedInThePoseIsFoundWithFewPosesAndInLargeSkins) {
  for (const auto& [patch, poses] : {std::pair("x17", 4U), std::pair("x17", 6U), std::pair("sheet:10x10", 4U)}) {
    const Session session =
        inThirdPose(test::simulatedSession(test::skinOptions(patch, "", 3), poses), [](GravitySample& sample) {
          if (sample.cell == CellId(8)) sample.mean_g += Eigen::Vector3d(0.12, 0, 0.12);
        });
    const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(3));
    const auto worst = std::ranges::max_element(
        result.cells, {}, [](const HoldOutCell& cell) { return cell.error_rad / cell.expected_rad; });
    EXPECT_EQ(worst->cell, CellId(8)) << patch << ", " << poses << " poses";
    EXPECT_NE(result.agreement, HoldOutAgreement::AsStated) << patch << ", " << poses << " poses";
  }
}

TEST(HoldOut, AnOffsetThatAllSensorsShareIsNoError) {
  const Session still = bentX17().session(orthogonalUps(6));
  const auto ofAll = [&](double drift_g) {
    const Session session = inThirdPose(
        still, [&](GravitySample& sample) { sample.mean_g += Eigen::Vector3d(drift_g, -drift_g, drift_g); });
    return evaluateHoldOut(*session.snapshot(), PoseId(3));
  };
  const HoldOutResult drifted = ofAll(0.003);
  EXPECT_EQ(drifted.agreement, HoldOutAgreement::AsStated);
  EXPECT_LT(drifted.rms_rad, 0.05 * kDegree) << "0.2 degrees if it were each sensor's own";
}

TEST(HoldOut, APartThatBentInThePoseIsFound) {
  // All that lies on one side of the part's middle was turned against the rest.
  for (const auto& [poses, angle] : {std::pair(4U, 10 * kDegree), std::pair(6U, 3 * kDegree)}) {
    SimulatedSkin skin = test::simulatedSkin();
    const Session session = inThirdPose(simulateSession(skin, poses), [&, angle = angle](GravitySample& sample) {
      const SE3& T_b_u = test::truePlacement(skin, sample.cell);
      const Eigen::Vector3d turn = angle * Eigen::Vector3d(0.3, 0.5, 0.8).normalized();
      if (T_b_u.t.y() > 0) sample.mean_g = T_b_u.R.transpose() * expSO3(turn) * T_b_u.R * sample.mean_g;
    });
    const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(3));
    EXPECT_EQ(result.agreement, HoldOutAgreement::FarWorse) << poses << " poses";
  }
}

TEST(HoldOut, ThreeOtherPosesAreACoarseCheckAndFiveAFineOne) {
  const HoldOutResult few = evaluateHoldOut(*test::simulatedSession({}, 4).snapshot(), PoseId(4));
  EXPECT_TRUE(few.coarse);
  EXPECT_GT(few.detectable_rad, 3 * kDegree);
  const HoldOutResult more = evaluateHoldOut(*test::simulatedSession({}, 6).snapshot(), PoseId(4));
  EXPECT_FALSE(more.coarse);
  EXPECT_LT(more.detectable_rad, 1.5 * kDegree);
}

TEST(HoldOut, APartThatWasTurnedWhileItWasReadIsFoundThoughItsReadingsAgree) {
  // A swing of 10 rad/s^2, as when the hand gives way: one motion of a rigid part, and no rest.
  SimulatedSkin skin = test::simulatedSkin();
  const Session still = simulateSession(skin, 6);
  const Session session = inThirdPose(still, [&](GravitySample& sample) {
    const SE3& T_b_u = test::truePlacement(skin, sample.cell);
    const Eigen::Vector3d swing = Eigen::Vector3d(6, -8, 0) / kStandardGravity;
    sample.mean_g += T_b_u.R.transpose() * swing.cross(T_b_u.t);
  });
  const HoldOutResult before = evaluateHoldOut(*still.snapshot(), PoseId(3));
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(3));
  EXPECT_EQ(before.agreement, HoldOutAgreement::AsStated);
  EXPECT_FALSE(before.turned);
  EXPECT_TRUE(result.turned);
  EXPECT_NEAR(result.turning_rad_s2, 10, 2.5);
  EXPECT_LT(result.rms_rad, 1.5 * result.expected_rms_rad);
  EXPECT_EQ(result.agreement, HoldOutAgreement::FarWorse);
}

TEST(HoldOut, NeedsThreeOtherPosesAndSaysSo) {
  const Session session = test::simulatedSession({}, 3);
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(1));
  EXPECT_EQ(result.outcome, HoldOutOutcome::TooFewPoses);
  EXPECT_EQ(result.other_poses, 2U);
  EXPECT_THAT(result.cells, IsEmpty());
}

TEST(HoldOut, DisabledPosesStayOutAndCanBeTheOne) {
  Session session = test::simulatedSession({}, 6);
  session.setPoseDisabled(1, true);
  EXPECT_EQ(evaluateHoldOut(*session.snapshot(), PoseId(1)).other_poses, 4U);
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(2));
  EXPECT_EQ(result.outcome, HoldOutOutcome::Evaluated);
  EXPECT_EQ(result.other_poses, 5U);
  EXPECT_THAT(result.cells, SizeIs(17));
}

TEST(HoldOut, HasNothingToCompareWhereAPatchIsASingleCell) {
  PinJointedSkin skin({{1, 2, 2, 3, 0, 0, 0}});
  skin.neighbors.clear();
  const HoldOutResult result = evaluateHoldOut(*skin.session(orthogonalUps(5)).snapshot(), PoseId(1));
  EXPECT_EQ(result.outcome, HoldOutOutcome::NothingToCompare);
  EXPECT_THAT(result.links, IsEmpty());
}

TEST(HoldOut, WorksOnWhatTheTreeSolverMakes) {
  const Session session = test::simulatedSession(test::skinOptions("x17", "", 2), 6);
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(6), test::by(Solver::Tree));
  EXPECT_EQ(result.outcome, HoldOutOutcome::Evaluated);
  EXPECT_GT(result.rms_rad, evaluateHoldOut(*session.snapshot(), PoseId(6)).rms_rad)
      << "raw readings are worse than corrected ones";
}

/// A scripted calibration whose windows have these numbers of samples, one after the other.
Session withWindows(SimulatedSkin& skin, std::size_t poses, const std::vector<std::size_t>& samples) {
  Session session = beginSimulatedSession(skin);
  std::size_t k = 0;
  for (const Eigen::Vector3d& up : scriptedUpDirections(poses)) {
    const auto frames = skin.record(up, samples[k++ % samples.size()]);
    session.addPose({std::make_shared<const PoseCapture>(averageFrames(frames, session.nextPoseId(), {})), false});
  }
  return session;
}

TEST(HoldOut, WindowsOfAnyLengthErrAsMuchAsExpected) {
  std::vector<double> of_short, of_long;
  std::size_t as_stated = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SimulatedSkin skin =
        test::simulatedSkin(test::with(test::skinOptions("x17", "", seed), &SimulatedSkinOptions::hand_held, false));
    const Session session = withWindows(skin, 10, {270, 6, 6, 57, 6});
    for (const std::uint32_t pose : {2U, 6U}) {
      const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(pose));
      ASSERT_EQ(result.outcome, HoldOutOutcome::Evaluated);
      (pose == 2 ? of_short : of_long).push_back(result.rms_rad / result.expected_rms_rad);
      if (result.agreement == HoldOutAgreement::AsStated) ++as_stated;
    }
  }
  for (std::vector<double>* ratios : {&of_short, &of_long}) {
    std::ranges::sort(*ratios);
    EXPECT_GT((*ratios)[10], 0.87);
    EXPECT_LT((*ratios)[10], 1.13);
  }
  EXPECT_GE(as_stated, 38U);
}

TEST(HoldOut, StopsWhenAskedAndRefusesUnknownPoses) {
  const Session session = test::simulatedSession({}, 4);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(evaluateHoldOut(*session.snapshot(), PoseId(1), {}, stop.get_token()).outcome, HoldOutOutcome::Stopped);
  EXPECT_THROW(evaluateHoldOut(*session.snapshot(), PoseId(9)), InvalidArgument);
  EXPECT_THROW(evaluateHoldOut(*session.snapshot(), PoseId(1), test::with(&SolverOptions::max_misfit, -1)),
               InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
