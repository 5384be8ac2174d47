// Skins of real chips: those of one lot share an offset and a scale, and each sits a little askew in its cell.

#include "hexoderm/base/median.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/matchers.h"
#include "tests/support/nees.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/slow_build.h"
#include "tests/support/solvers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

constexpr std::uint64_t kLots = test::kSlowBuild ? 4 : 24;

CellModel chips(double own_g, double shared_g, double shared_scale) {
  CellModel model = builtInCellModel("hex-bma150");
  model.accelerometer.offset_sigma_g.setConstant(own_g);
  model.accelerometer.offset_shared_sigma_g = shared_g;
  model.accelerometer.scale_shared_sigma = shared_scale;
  return model;
}

struct Outcome {
  std::vector<double> errors_rad;  ///< rms over the cells, per skin
  test::Nees nees;
  std::size_t accused = 0;
  [[nodiscard]] double typicalError_deg() const { return toDegrees(median(errors_rad)); }
};

/// Skins of chips of `real`, estimated by `believed`.
Outcome calibrate(const CellModel& real, const CellModel& believed, const std::string& patch, std::size_t poses,
                  Solver solver = Solver::Global) {
  Outcome outcome;
  for (std::uint64_t seed = 1; seed <= kLots; ++seed) {
    SimulatedSkin skin(real, test::skinOptions(patch, "", seed));
    Session session = simulateSession(skin, poses);
    session.setSkin(believed, session.neighbors());
    const auto result = reconstruct(*session.snapshot(), test::by(solver));
    outcome.errors_rad.push_back(compareToTruth(*result, *session.truth()).at(0).orientation_rms_rad);
    outcome.accused += static_cast<std::size_t>(std::ranges::count_if(
        result->findings, [](const Finding& finding) { return finding.severity != Severity::Info; }));
    outcome.nees.addPatch(result->patches.front(), [&](CellId cell) { return test::truePlacement(skin, cell); });
  }
  return outcome;
}

TEST(Lot, MakesFewPosesMoreExactThanIndependentErrorsOfTheSameSize) {
  const CellModel real = chips(0.015, 0.05, 0);
  const CellModel independent = chips(std::hypot(0.015, 0.05), 0, 0);
  const Outcome known = calibrate(real, real, "x17", 2);
  const Outcome unknown = calibrate(real, independent, "x17", 2);
  EXPECT_LT(known.typicalError_deg(), 1.9);
  EXPECT_LT(known.typicalError_deg(), 0.75 * unknown.typicalError_deg());
}

TEST(Lot, AccusesNoHealthyCellAndStatesWhatItKnows) {
  for (const char* patch : {"x17", "ring8:closed"}) {
    for (const double scale : {0.0, 0.1}) {
      const CellModel model = chips(0.015, 0.05, scale);
      for (const std::size_t poses : {2U, 4U}) {
        const Outcome outcome = calibrate(model, model, patch, poses);
        const std::string what = patch + (", scale " + std::to_string(scale)) + ", poses " + std::to_string(poses);
        EXPECT_EQ(outcome.accused, 0U) << what;
        EXPECT_GT(outcome.nees.orientation, 0.6) << what;
        EXPECT_LT(outcome.nees.orientation, 1.6) << what;
      }
    }
  }
}

TEST(Lot, OfChipsThatSitAskewIsKnownNoBetterThanTheirCells) {
  CellModel model = chips(0.015, 0.05, 0.1);
  model.mounting_sigma_rad = 1 * kDegree;
  CellModel straight = model;
  straight.mounting_sigma_rad = 0;
  for (const char* patch : {"x17", "ring8:closed", "sheet:4x4"}) {
    const Outcome outcome = calibrate(model, model, patch, 6);
    EXPECT_EQ(outcome.accused, 0U) << patch;
    for (const double square : {outcome.nees.orientation, outcome.nees.position}) {
      EXPECT_GT(square, 0.6) << patch;
      EXPECT_LT(square, 1.5) << patch;
    }
    EXPECT_GT(calibrate(model, straight, patch, 6).nees.orientation, 5) << patch;
  }
}

TEST(Lot, IsStatedWithItsUncertainty) {
  const CellModel real = chips(0.015, 0.05, 0.1);
  CellModel alike = chips(0, 0.05, 0.1);  // the same lots, of chips that have no errors of their own
  alike.accelerometer.scale_sigma = alike.accelerometer.cross_axis_sigma = 0;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= kLots; ++seed) {
    SimulatedSkin skin(real, test::skinOptions("x17", "", seed));
    const SimulatedSkin same_lot(alike, test::skinOptions("x17", "", seed));
    const TrueCell& truth = same_lot.truth().front();
    const auto result = reconstruct(*simulateSession(skin, 4).snapshot());
    const LotEstimate& lot = result->patches.front().lot.value();
    squares += (lot.offset_g - truth.offset_g).cwiseQuotient(lot.offset_sigma_g).squaredNorm() / 4;
    squares += std::pow(std::log(lot.scale / truth.gain(0, 0)) / lot.scale_sigma, 2) / 4;
    EXPECT_LT(lot.offset_sigma_g.maxCoeff(), 0.015) << seed;
    EXPECT_LT(lot.scale_sigma, 0.02) << seed;
  }
  EXPECT_GT(squares, 0.6 * kLots);
  EXPECT_LT(squares, 1.6 * kLots);
}

TEST(Lot, IsAllOfChipsThatAreAlike) {
  CellModel alike = chips(0, 0.05, 0.1);
  alike.accelerometer.scale_sigma = alike.accelerometer.cross_axis_sigma = alike.mounting_sigma_rad = 0;
  SimulatedSkinOptions options = SimulatedSkinOptions::ideal();
  options.sensor_errors = true;
  SimulatedSkin skin(alike, options);
  const TrueCell& truth = skin.truth().front();
  Session session = simulateSession(skin, 6);
  session.setSkin(chips(0.005, 1, 1), session.neighbors());  // so wide that it hardly pulls
  const auto result = reconstruct(*session.snapshot());
  const PatchReconstruction& patch = result->patches.front();
  ASSERT_TRUE(patch.lot);
  EXPECT_LT((patch.lot->offset_g - truth.offset_g).norm(), 1e-5);
  EXPECT_NEAR(patch.lot->scale, truth.gain(0, 0), 1e-5);
  // What a cell's chip reads by as a whole holds the lot's part. The elastomer's priors pull at single cells.
  for (const CellPlacement& cell : patch.cells) {
    EXPECT_LT((*cell.accel_offset_g - truth.offset_g).norm(), 1e-4);
    EXPECT_LT((cell.accel_scale->array() - truth.gain(0, 0)).matrix().norm(), 1e-4);
  }
}

TEST(Lot, IsWhatTheModelSaysWithoutAPoseAndNotStatedWhereNobodyEstimatesIt) {
  const CellModel model = chips(0.015, 0.05, 0.1);
  SimulatedSkin skin(model, test::skinOptions("x17"));
  const auto unread = reconstruct(*simulateSession(skin, 0).snapshot());
  const LotEstimate& lot = unread->patches.front().lot.value();
  EXPECT_EQ(lot.offset_g, Eigen::Vector3d::Zero());
  EXPECT_EQ(lot.scale, 1);
  EXPECT_TRUE(lot.offset_sigma_g.isApproxToConstant(0.05, 1e-9));
  EXPECT_NEAR(lot.scale_sigma, 0.1, 1e-9);
  const Session session = simulateSession(skin, 2);
  EXPECT_FALSE(reconstruct(*session.snapshot(), test::by(Solver::Tree))->patches.front().lot);
  Session without = session;
  without.setSkin(chips(0.05, 0, 0), session.neighbors());
  EXPECT_FALSE(reconstruct(*without.snapshot())->patches.front().lot);
}

TEST(Lot, OfTheTreeIsCountedInItsLinks) {
  const CellModel model = chips(0.015, 0.05, 0.1);
  const Outcome outcome = calibrate(model, model, "x17", 3, Solver::Tree);
  EXPECT_EQ(outcome.accused, 0U);
  EXPECT_GT(outcome.nees.count, 0);
  EXPECT_LT(outcome.nees.orientation, 2);
}

}  // namespace
}  // namespace hexoderm
