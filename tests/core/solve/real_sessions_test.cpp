// Sessions of a real robot's leg, whose boards hold accelerometers (README of the reference data): what is wrong with
// them is named, and what is real in them is not. There is no truth for positions, and gravity is seen from two
// directions only.

#include "hexoderm/base/units.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/hold_out.h"
#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/sensor_statistics.h"
#include "tests/support/matchers.h"
#include "tests/support/paths.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

Session real(const std::string& name) {
  return readSessionJson(std::string(HEXODERM_REFERENCE_DATA) + "/real/icub_leg/" + name + ".session.json");
}
std::shared_ptr<const Reconstruction> solvedReal(const std::string& name, const SolverOptions& options = {}) {
  return reconstruct(*real(name).snapshot(), options);
}

// --- verdicts

/// Two sessions get the same verdict, with uncertainties that differ by no more than a share.
void expectSameVerdict(const std::string& name, const std::string& other_name, double orientation,
                       const std::optional<double>& position = {}) {
  const Assessment one = solvedReal(name)->assessment;
  const Assessment other = solvedReal(other_name)->assessment;
  EXPECT_THAT(one, IsVerdict(other.level, other.limit, other.remedy));
  EXPECT_NEAR(*one.orientation_95_rad, *other.orientation_95_rad, orientation * *other.orientation_95_rad);
  if (position) {
    EXPECT_NEAR(*one.position_95_m, *other.position_95_m, *position * *other.position_95_m);
  }
}

TEST(RealSessions, TheSameInformationCutIntoMorePosesGetsTheSameVerdict) {
  expectSameVerdict("three_holds_cut_into_five", "three_holds", 0.2);
}

TEST(RealSessions, ADeadCellMattersAlikeWhateverItsNumber) {
  expectSameVerdict("dead_cell_is_origin", "dead_cell_is_not_origin", 0.01, 0.01);
}

// --- what is wrong

class RealGarbage : public ::testing::TestWithParam<Solver> {
 protected:
  /// Of links and cells; poses are told apart as they are.
  [[nodiscard]] static std::vector<Finding> accusations(const std::string& name) {
    std::vector<Finding> found = solvedReal(name, test::by(GetParam()))->findings;
    std::erase_if(found,
                  [](const Finding& finding) { return finding.severity == Severity::Info || finding.cells.empty(); });
    return found;
  }
};

INSTANTIATE_TEST_SUITE_P(Solvers, RealGarbage, ::testing::Values(Solver::Global, Solver::Tree), test::solverOfTest);

TEST_P(RealGarbage, ABoardTurnedBy180DegreesIsNamed) {
  const std::vector<Finding> found = accusations("turned_180_not_seen");
  ASSERT_FALSE(found.empty());
  for (const Finding& finding : found) EXPECT_THAT(finding.cells, Contains(CellId(38)));
}

TEST_P(RealGarbage, ALinkAroundTheThighIsNoSkinLink) {
  const std::vector<Finding> found = accusations("link_around_the_thigh");
  ASSERT_FALSE(found.empty());
  for (const Finding& finding : found) EXPECT_THAT(finding.cells, UnorderedElementsAre(CellId(41), CellId(44)));
}

/// Real links twist by up to 50 degrees, far more than the simulator's.
TEST_P(RealGarbage, SoundBoardsAreNotAccused) {
  for (const std::string name : {"three_holds", "three_holds_cut_into_five", "one_long_and_twelve_short_windows"}) {
    EXPECT_THAT(accusations(name), IsEmpty()) << name;
  }
}

/// With the ports' heights from the drawing, by which links fold by up to 65 degrees; and with the same links cut at
/// other points between the two cells.
TEST_P(RealGarbage, PortsWithHeightFoldTheLinks) {
  const Session drawn = real("three_holds_ports_with_height");
  for (const double of_odd_ports : {1.0, 1.3, 0.6}) {
    CellModel model = drawn.model();
    for (Port& port : model.ports) port.vector_m *= port.number.value() % 2 == 1 ? of_odd_ports : 2 - of_odd_ports;
    Session session(model, drawn.neighbors());
    for (const SessionPose& pose : drawn.poses()) session.addPose(pose);
    const auto result = reconstruct(*session.snapshot(), test::by(GetParam()));
    for (const Finding& found : result->findings) EXPECT_EQ(found.severity, Severity::Info) << found.message.english();
    const std::vector<Comparison> compared = compareToTruth(*result, *drawn.truth());
    ASSERT_THAT(compared, SizeIs(1));
    EXPECT_EQ(compared.front().cells.size(), 5U);
    EXPECT_LT(compared.front().orientation_rms_rad, 2.5 * kDegree) << of_odd_ports;
  }
}

/// Orientations of the tree, on the average over the cells and against the joint estimate from the same readings, by
/// default and as in the paper: support axes pull links towards straight that two directions of gravity show well.
TEST(RealTree, IsNotWorseByDefaultThanThePapersMethod) {
  for (const std::string name : {"three_holds", "three_holds_cut_into_five", "link_around_the_thigh"}) {
    const auto joint = solvedReal(name);
    const auto offOf = [&](const SolverOptions& options) {
      const auto result = solvedReal(name, options);
      double sum = 0;
      for (const CellPlacement& cell : largestPatch(*joint)->cells) {
        const CellId origin = largestPatch(*joint)->origin;
        const Eigen::Matrix3d R =
            result->find(origin).cell->T_o_u.R.transpose() * result->find(cell.cell).cell->T_o_u.R;
        const double off = rotationAngle(R.transpose() * joint->find(origin).cell->T_o_u.R.transpose() * cell.T_o_u.R);
        sum += off * off;
      }
      return std::sqrt(sum / static_cast<double>(largestPatch(*joint)->cells.size()));
    };
    EXPECT_LE(offOf(test::by(Solver::Tree)), offOf(test::papersMethod()) + 1e-9) << name;
  }
}

// --- the boards' sensors

// Known of these boards otherwise.
constexpr double kOffset_g = 0.020;
constexpr double kScale = 0.005;
constexpr double kSymmetricCrossAxis = 0.015;  // half the sum of two elements

SensorStatistics statisticsOf(const std::string& name) {
  return *estimateSensorStatistics(std::vector{real(name).snapshot()});
}

TEST(RealSensors, ThreeHoldsTellNoErrors) {
  const SensorStatistics statistics = statisticsOf("three_holds");
  const SensorSigmas& sigmas = statistics.sigmas;
  EXPECT_EQ(statistics.cells_used, 5U);
  EXPECT_NE(sigmas.offset_g.knowledge, SigmaKnowledge::Measured)
      << "two directions tell no lot's offset from its scale";
  EXPECT_EQ(sigmas.scale.knowledge, SigmaKnowledge::Unknown);
  EXPECT_EQ(sigmas.cross_axis.knowledge, SigmaKnowledge::Unknown);
}

TEST(RealSensors, FifteenWindowsTellTheCrossAxisSensitivityRoughly) {
  const SensorSigmas sigmas = statisticsOf("one_long_and_twelve_short_windows").sigmas;
  ASSERT_EQ(sigmas.cross_axis.knowledge, SigmaKnowledge::Measured);
  EXPECT_LE(sigmas.cross_axis.low_95, std::sqrt(2.0) * kSymmetricCrossAxis);
  EXPECT_GE(sigmas.cross_axis.high_95, std::sqrt(2.0) * kSymmetricCrossAxis);
  EXPECT_LT(sigmas.cross_axis.worth, 10);
  for (const auto& [estimate, known] : {std::pair(sigmas.offset_g, kOffset_g), std::pair(sigmas.scale, kScale)}) {
    EXPECT_NE(estimate.knowledge, SigmaKnowledge::Measured) << "two directions are not enough";
    EXPECT_TRUE(estimate.knowledge == SigmaKnowledge::Unknown || estimate.high_95 >= known) << estimate.high_95;
  }
}

TEST(RealSensors, ModelsThatGrantMoreThanTheBoardsNeedAreNotContradicted) {
  for (const std::string name : {"three_holds", "three_holds_cut_into_five", "one_long_and_twelve_short_windows"}) {
    EXPECT_EQ(std::ranges::count(solvedReal(name)->findings, FindingCode::SensorsUnlikeModel, &Finding::code), 0)
        << name;
  }
}

// --- motionless windows of very different length

TEST(RealWindows, OfAnyLengthAreForetoldAsStated) {
  const Session session = real("one_long_and_twelve_short_windows");
  ASSERT_EQ(session.poses().size(), 15U);
  std::vector<double> ratios;
  for (const SessionPose& pose : session.poses()) {
    const HoldOutResult result = evaluateHoldOut(*session.snapshot(), pose.capture->id);
    ASSERT_EQ(result.outcome, HoldOutOutcome::Evaluated);
    const double ratio = result.rms_rad / result.expected_rms_rad;
    EXPECT_EQ(result.agreement, HoldOutAgreement::AsStated)
        << "pose " << pose.capture->id.value() << ": rms " << ratio << " times what is expected, turning "
        << result.turning_rad_s2 / result.expected_turning_rad_s2;
    ratios.push_back(ratio);
  }
  std::ranges::sort(ratios);
  EXPECT_GT(ratios[7], 0.7);
  EXPECT_LT(ratios[7], 1.3);
}

}  // namespace
}  // namespace hexoderm
