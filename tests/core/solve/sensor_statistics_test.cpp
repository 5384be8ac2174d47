// Sigmas of sensors from whole sessions of simulated skins, whose sigmas are known, and skins that contradict their
// model.

#include "hexoderm/solve/sensor_statistics.h"

#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/solve.h"
#include "tests/support/independent_chips.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/slow_build.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using Snapshots = std::vector<std::shared_ptr<const SessionSnapshot>>;

using test::kSlowBuild;

/// `offset_g`: of all of it.
CellModel modelWith(double offset_g, double shared_g, double scale, double cross_axis) {
  CellModel model = builtInCellModel("hex-bma150");
  model.accelerometer.offset_sigma_g.setConstant(std::sqrt(offset_g * offset_g - shared_g * shared_g));
  model.accelerometer.offset_shared_sigma_g = shared_g;
  model.accelerometer.scale_sigma = scale;
  model.accelerometer.scale_shared_sigma = 0;
  model.accelerometer.cross_axis_sigma = cross_axis;
  return model;
}

struct Skin {
  std::string patch = "x17";
  std::size_t poses = 6;
  std::uint64_t seed = 1;
};

/// A session of a skin whose sensors are as in `real`, and whose cell model is `believed`.
std::shared_ptr<const SessionSnapshot> simulate(const CellModel& real, const CellModel& believed, const Skin& what) {
  SimulatedSkin skin(real, test::skinOptions(what.patch, "", what.seed));
  Session session = simulateSession(skin, what.poses);
  CellModel model = believed;
  model.interface_id = skin.model().interface_id;
  session.setSkin(std::move(model), session.neighbors());
  return session.snapshot();
}

std::size_t contradictions(const SessionSnapshot& session) {
  const auto result = reconstruct(session);
  return static_cast<std::size_t>(
      std::ranges::count(result->findings, FindingCode::SensorsUnlikeModel, &Finding::code));
}

TEST(SensorStatistics, KnownSigmasLieInTheirRanges) {
  const CellModel believed = builtInCellModel("hex-bma150");
  struct Real {
    double offset_g;
    double scale;
    double cross_axis;
  };
  int measured = 0;
  int within = 0;
  double ratios = 0;
  const std::uint64_t seeds = kSlowBuild ? 1 : 2;
  for (const Real& real : {Real{0.06, 0.02, 0.005}, Real{0.02, 0.01, 0.015}, Real{0.12, 0.03, 0.01}}) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Snapshots sessions = {
          simulate(modelWith(real.offset_g, 0, real.scale, real.cross_axis), believed, {.seed = seed})};
      const auto statistics = estimateSensorStatistics(sessions);
      ASSERT_TRUE(statistics);
      EXPECT_TRUE(statistics->settled);
      EXPECT_GE(statistics->cells_used, 15U);
      const auto check = [&](const SigmaEstimate& estimate, double sigma, const char* what) {
        SCOPED_TRACE(std::string(what) + " " + std::to_string(sigma) + ", seed " + std::to_string(seed));
        ASSERT_EQ(estimate.knowledge, SigmaKnowledge::Measured) << estimate.worth;
        ++measured;
        within += estimate.low_95 <= sigma && sigma <= estimate.high_95 ? 1 : 0;
        ratios += estimate.sigma / sigma;
        EXPECT_LT(estimate.high_95, 2.2 * estimate.low_95);
      };
      check(statistics->sigmas.offset_g, real.offset_g, "offset");
      check(statistics->sigmas.scale, real.scale, "scale");
      check(statistics->sigmas.cross_axis, real.cross_axis, "cross-axis");
    }
  }
  if (kSlowBuild) return;
  EXPECT_GE(within, 0.88 * measured) << within << " of " << measured;
  EXPECT_NEAR(ratios / measured, 1, 0.05);
}

TEST(SensorStatistics, SeveralSkinsNarrowTheRanges) {
  const CellModel model = builtInCellModel("hex-bma150");
  Snapshots sessions;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    sessions.push_back(simulate(model, model, {.patch = "ring8", .seed = seed}));
  const auto one = estimateSensorStatistics(Snapshots{sessions.front()});
  const auto all = estimateSensorStatistics(sessions);
  ASSERT_EQ(all->sigmas.offset_g.knowledge, SigmaKnowledge::Measured);
  EXPECT_GT(all->sigmas.offset_g.worth, 3 * one->sigmas.offset_g.worth);
  EXPECT_EQ(all->cells, 4 * one->cells);
  EXPECT_LE(all->sigmas.offset_g.low_95, 0.06);
  EXPECT_GE(all->sigmas.offset_g.high_95, 0.06);
  EXPECT_EQ(all->same_cells.size(), 6U);  // rings of eight look alike
  EXPECT_TRUE(one->same_cells.empty());
}

TEST(SensorStatistics, TheOffsetOfALotIsFound) {
  const CellModel believed = builtInCellModel("hex-bma150");
  const CellModel real = modelWith(0.05, 0.04, 0.01, 0.005);
  const int seeds = kSlowBuild ? 1 : 7;
  int within = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Skin what{.seed = static_cast<std::uint64_t>(seed)};
    const SimulatedSkin skin(real, test::skinOptions(what.patch, "", what.seed));
    Eigen::Vector3d mean_g = Eigen::Vector3d::Zero();
    for (const TrueCell& cell : skin.truth()) mean_g += cell.offset_g / static_cast<double>(skin.truth().size());
    const auto statistics = estimateSensorStatistics(Snapshots{simulate(real, believed, what)});
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_TRUE(statistics->sigmas.lot);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(statistics->sigmas.lot->offset_g[axis], mean_g[axis], 0.008);
    }
    const SigmaEstimate& shared = statistics->sigmas.shared_offset_g;
    ASSERT_NE(shared.knowledge, SigmaKnowledge::Unknown);
    within += shared.low_95 <= 0.04 && shared.high_95 >= 0.04 ? 1 : 0;
  }
  EXPECT_GE(within, 0.85 * seeds) << "three numbers of each lot";
}

TEST(SensorStatistics, TheScaleOfALotIsToldFromThatOfItsChips) {
  const CellModel believed = builtInCellModel("hex-bma150");
  CellModel real = modelWith(std::hypot(0.015, 0.05), 0.05, 0.005, 0.005);
  real.accelerometer.scale_shared_sigma = 0.1;
  // By the sessions' model, the whole of the last one is broken.
  for (const Skin& what : {Skin{"x17", 6, 1}, Skin{"x17", 6, 2}, Skin{"x17", 4, 3}, Skin{"ring8:closed", 6, 1}}) {
    SCOPED_TRACE(what.patch + ", seed " + std::to_string(what.seed));
    const SimulatedSkin skin(real, test::skinOptions(what.patch, "", what.seed));
    double scale = 0;
    for (const TrueCell& cell : skin.truth()) {
      scale += cell.gain.trace() / 3 / static_cast<double>(skin.truth().size());
    }
    const auto statistics = estimateSensorStatistics(Snapshots{simulate(real, believed, what)});
    const SensorSigmas& sigmas = statistics->sigmas;
    ASSERT_EQ(sigmas.scale.knowledge, SigmaKnowledge::Measured);
    EXPECT_LE(sigmas.scale.low_95, 0.005);
    EXPECT_GE(sigmas.scale.high_95, 0.005);
    ASSERT_TRUE(sigmas.lot);
    EXPECT_NEAR(sigmas.lot->scale, scale, 0.01);
    const Accelerometer& written = statistics->model.accelerometer;
    EXPECT_NEAR(written.scale_shared_sigma, std::abs(scale - 1), 0.01);
    EXPECT_LT(written.scale_sigma, 0.01);
  }
}

TEST(SensorStatistics, OnePoseTellsNothingAndTwoNothingOfTheAxes) {
  const CellModel model = builtInCellModel("hex-bma150");
  const auto statistics = estimateSensorStatistics(Snapshots{simulate(model, model, {.poses = 1})});
  EXPECT_FALSE(statistics->knowsAnything());
  EXPECT_EQ(cellModelToJson(statistics->model), cellModelToJson(model));
  for (std::uint64_t seed = 1; seed <= (kSlowBuild ? 1 : 2); ++seed) {
    const auto two = estimateSensorStatistics(Snapshots{simulate(model, model, {.poses = 2, .seed = seed})});
    EXPECT_EQ(two->sigmas.cross_axis.knowledge, SigmaKnowledge::Unknown) << two->sigmas.cross_axis.worth;
    EXPECT_EQ(two->model.accelerometer.cross_axis_sigma, model.accelerometer.cross_axis_sigma);
    // Whatever is told of the others is not wrong.
    if (two->sigmas.offset_g.knowledge == SigmaKnowledge::Measured) {
      EXPECT_LE(two->sigmas.offset_g.low_95, 0.06);
      EXPECT_GE(two->sigmas.offset_g.high_95, 0.06);
    }
  }
}

TEST(SensorStatistics, TheModelIsTheSessionsWithOtherSigmasAndReadsBack) {
  const CellModel model = builtInCellModel("hex-bma150");
  const auto statistics = estimateSensorStatistics(Snapshots{simulate(modelWith(0.03, 0.02, 0.01, 0.01), model, {})});
  const CellModel back = cellModelFromJson(cellModelToJson(statistics->model), "chip.json");
  EXPECT_EQ(cellModelToJson(back), cellModelToJson(statistics->model));
  EXPECT_DOUBLE_EQ(back.accelerometer.ofUnknownLot().largestOffsetSigma_g(), statistics->sigmas.offset_g.sigma);
  CellModel with_old_sigmas = back;
  with_old_sigmas.accelerometer = model.accelerometer;
  EXPECT_EQ(cellModelToJson(with_old_sigmas), cellModelToJson(model));
}

#ifdef NDEBUG  // in a slow build it takes minutes, and the same code as the others
TEST(SensorStatistics, ALargeSkinIsLookedAtInPart) {
  const CellModel model = builtInCellModel("hex-bma150");
  const auto statistics =
      estimateSensorStatistics(Snapshots{simulate(model, model, {.patch = "sheet:10x10", .poses = 4})});
  EXPECT_EQ(statistics->cells, 100U);
  EXPECT_LE(statistics->cells_used, kMaxCellsForSensors);
  EXPECT_GE(statistics->cells_used, kMaxCellsForSensors - 5);
  EXPECT_EQ(statistics->sigmas.offset_g.knowledge, SigmaKnowledge::Measured);
}
#endif

TEST(SensorStatistics, WhatDoesNotBelongTogetherIsRefused) {
  const CellModel model = builtInCellModel("hex-bma150");
  const Snapshots sessions = {simulate(model, model, {.poses = 2}),
                              simulate(model, modelWith(0.02, 0, 0.02, 0.005), {.poses = 2})};
  EXPECT_THROW((void)estimateSensorStatistics(sessions), InvalidArgument);
  EXPECT_THROW((void)estimateSensorStatistics({}), InvalidArgument);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(estimateSensorStatistics(Snapshots{sessions.front()}, stop.get_token()));
}

/// What readings say does not depend on what was believed before, but for the point at which all is linear.
TEST(PatchEvidence, DoesNotDependOnThePrior) {
  const CellModel narrow = builtInCellModel("hex-bma150");
  CellModel wide = narrow;
  wide.accelerometer.offset_sigma_g *= 2;
  wide.accelerometer.scale_sigma *= 2;
  wide.accelerometer.cross_axis_sigma *= 2;
  const auto evidenceWith = [&](const CellModel& believed) {
    const auto session = simulate(narrow, believed, {.patch = "ring8"});
    const SolverOptions options;
    return solveSkin(*session, options)->patches().front().joint()->sensorEvidence();
  };
  const SensorEvidence a = evidenceWith(narrow);
  const SensorEvidence b = evidenceWith(wide);
  ASSERT_EQ(a.sensors(), 8U);
  EXPECT_LT((a.information - b.information).norm(), 0.05 * a.information.norm());
  // Compared as the errors that they make likely under one prior.
  const Eigen::VectorXd prior = priorVariances(narrow.accelerometer, 8);
  const Eigen::VectorXd errors_a = prior.cwiseProduct(weigh(a, prior).weighted);
  const Eigen::VectorXd errors_b = prior.cwiseProduct(weigh(b, prior).weighted);
  EXPECT_LT((errors_a - errors_b).norm(), 0.1 * errors_a.norm());
}

TEST(UnlikelySensors, OffsetsThreeTimesAsLargeAreNamed) {
  const CellModel believed = independentChips();
  const CellModel real = modelWith(0.18, 0, 0.02, 0.005);
  const std::size_t seeds = kSlowBuild ? 2 : 20;
  std::size_t of_x17 = 0;
  std::size_t of_ring = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    of_x17 += contradictions(*simulate(real, believed, {"x17", 6, seed}));
    of_ring += contradictions(*simulate(real, believed, {"ring8", 6, seed}));
  }
  EXPECT_EQ(of_x17, seeds);
  // So large errors pass for broken sensors and joints, after which little may be left of eight cells.
  EXPECT_GE(of_ring, kSlowBuild ? 0 : seeds * 9 / 10);
}

TEST(UnlikelySensors, CrossAxisSensitivityAndScaleAreNamedByTheirKind) {
  const CellModel believed = builtInCellModel("hex-bma150");
  const auto textOf = [&](const CellModel& real) {
    const auto result = reconstruct(*simulate(real, believed, {}));
    const auto found = std::ranges::find(result->findings, FindingCode::SensorsUnlikeModel, &Finding::code);
    return found == result->findings.end() ? std::string() : found->message.english();
  };
  EXPECT_THAT(textOf(modelWith(0.06, 0, 0.02, 0.03)), ::testing::HasSubstr("cross-axis sensitivities of"));
  EXPECT_THAT(textOf(modelWith(0.06, 0, 0.08, 0.005)), ::testing::HasSubstr("scale errors of"));
}

TEST(UnlikelySensors, TheModelThatComesOutIsNotContradicted) {
  const CellModel believed = builtInCellModel("hex-bma150");
  const auto session = simulate(modelWith(0.18, 0, 0.02, 0.02), believed, {});
  ASSERT_EQ(contradictions(*session), 1U);
  SessionSnapshot again = *session;
  again.model = std::make_shared<const CellModel>(estimateSensorStatistics(Snapshots{session})->model);
  EXPECT_EQ(contradictions(again), 0U);
}

}  // namespace
}  // namespace hexoderm
