#include "hexoderm/reconstruction/hold_out.h"

#include "hexoderm/device/simulated_skin.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/units.h"
#include "support/matchers.h"
#include "support/pin_jointed_skin.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

using ::testing::Each;
using ::testing::Field;
using ::testing::IsEmpty;
using ::testing::Lt;
using ::testing::SizeIs;

Session simulated(const std::string& patch, std::uint64_t seed, std::size_t poses) {
  SimulatedSkinOptions options;
  options.patch = patch;
  options.seed = seed;
  SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
  return simulateSession(skin, poses);
}

/// The session with one reading of one pose turned about the cell's z.
Session withReadingTurned(const Session& session, std::size_t pose, CellId cell, double angle_rad) {
  Session result(session.model(), session.neighbors());
  for (std::size_t k = 0; k < session.poses().size(); ++k) {
    PoseCapture capture = *session.poses()[k].capture;
    for (GravitySample& sample : capture.samples) {
      if (k == pose && sample.cell == cell) sample.mean_g = expSO3({angle_rad, 0, angle_rad}) * sample.mean_g;
    }
    result.addPose({std::make_shared<const PoseCapture>(std::move(capture)), session.poses()[k].disabled});
  }
  return result;
}

TEST(HoldOut, ExactReadingsAreForetoldExactly) {
  const Session session = bentX17().session(orthogonalUps(6));
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(4));
  EXPECT_EQ(result.outcome, HoldOutOutcome::Evaluated);
  EXPECT_EQ(result.other_poses, 5U);
  ASSERT_THAT(result.cells, SizeIs(17));
  EXPECT_THAT(result.links, SizeIs(16));
  EXPECT_EQ(result.degrees_of_freedom, 32U);
  // Priors pull a little.
  EXPECT_THAT(result.cells, Each(Field(&HoldOutCell::error_rad, Lt(0.02 * kDegree))));
  EXPECT_EQ(result.agreement, HoldOutAgreement::AsStated);
  EXPECT_GT(result.expected_rms_rad, 0.05 * kDegree) << "what is stated does not know that nothing is wrong";
}

TEST(HoldOut, ErrorsAreAsLargeAsExpectedInTheMeanOverSeeds) {
  // Of hand-held skins with uncalibrated sensors, for three to seven other poses: the mean of the squares, in units of
  // what is expected. A hand's tremor moves all cells alike, and each is granted it, so with many poses less is seen
  // than expected, most of all between neighbours.
  for (const std::size_t poses : {4U, 6U, 8U}) {
    double squares = 0;
    double expected = 0;
    double link_squares = 0;
    double link_expected = 0;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      const Session session = simulated("x17", seed, poses);
      const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(static_cast<std::uint32_t>(poses)));
      ASSERT_EQ(result.outcome, HoldOutOutcome::Evaluated);
      squares += result.rms_rad * result.rms_rad;
      expected += result.expected_rms_rad * result.expected_rms_rad;
      for (const HoldOutLink& link : result.links) {
        link_squares += link.error_rad * link.error_rad;
        link_expected += link.expected_rad * link.expected_rad;
      }
    }
    RecordProperty("nees_" + std::to_string(poses), std::to_string(squares / expected));
    EXPECT_GT(squares / expected, 0.35) << poses << " poses";
    EXPECT_LT(squares / expected, 1.6) << poses << " poses";
    EXPECT_GT(link_squares / link_expected, 0.1) << poses << " poses";
    EXPECT_LT(link_squares / link_expected, 1.6) << poses << " poses";
  }
}

TEST(HoldOut, ACellThatReadsOtherwiseInThePoseStandsOut) {
  const Session session = withReadingTurned(simulated("x17", 3, 6), 2, CellId(8), 20 * kDegree);
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

TEST(HoldOut, TurningTheWholePartInThePoseChangesNothing) {
  const PinJointedSkin skin = bentX17();
  std::vector<Eigen::Vector3d> ups = orthogonalUps(5);
  const HoldOutResult before = evaluateHoldOut(*skin.session(ups).snapshot(), PoseId(5));
  ups[4] = expSO3({0.3, 0.8, -0.2}) * ups[4];
  const HoldOutResult after = evaluateHoldOut(*skin.session(ups).snapshot(), PoseId(5));
  EXPECT_LT(after.rms_rad, 0.02 * kDegree);
  EXPECT_LT(before.rms_rad, 0.02 * kDegree);
}

TEST(HoldOut, NeedsThreeOtherPosesAndSaysSo) {
  const Session session = simulated("x17", 1, 3);
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(1));
  EXPECT_EQ(result.outcome, HoldOutOutcome::TooFewPoses);
  EXPECT_EQ(result.other_poses, 2U);
  EXPECT_THAT(result.cells, IsEmpty());
}

TEST(HoldOut, DisabledPosesStayOutAndCanBeTheOne) {
  Session session = simulated("x17", 1, 6);
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
  EXPECT_EQ(result.degrees_of_freedom, 0U);
}

TEST(HoldOut, WorksOnWhatTheTreeSolverMakes) {
  SolverOptions options;
  options.solver = Solver::Tree;
  const Session session = simulated("x17", 2, 6);
  const HoldOutResult result = evaluateHoldOut(*session.snapshot(), PoseId(6), options);
  EXPECT_EQ(result.outcome, HoldOutOutcome::Evaluated);
  EXPECT_GT(result.rms_rad, evaluateHoldOut(*session.snapshot(), PoseId(6)).rms_rad)
      << "raw readings are worse than corrected ones";
}

TEST(HoldOut, StopsWhenAskedAndRefusesUnknownPoses) {
  const Session session = simulated("x17", 1, 4);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(evaluateHoldOut(*session.snapshot(), PoseId(1), {}, stop.get_token()).outcome, HoldOutOutcome::Stopped);
  EXPECT_THROW(evaluateHoldOut(*session.snapshot(), PoseId(9)), InvalidArgument);
  SolverOptions bad;
  bad.max_misfit = -1;
  EXPECT_THROW(evaluateHoldOut(*session.snapshot(), PoseId(1), bad), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
