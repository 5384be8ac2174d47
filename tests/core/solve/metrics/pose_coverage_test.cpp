#include "hexoderm/solve/metrics/pose_coverage.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/global/rigidity.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/random_vector.h"
#include "tests/support/result_builder.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using Ups = std::vector<Eigen::Vector3d>;

const CellModel kModel = builtInCellModel("hex-bma150");

std::shared_ptr<const Reconstruction> solved(const Ups& ups) { return reconstruct(*bentX17().session(ups).snapshot()); }

/// Exact live readings of the pin-jointed skin with `up` (root's frame) upwards.
std::vector<CellSample> readings(const Eigen::Vector3d& up) {
  std::vector<CellSample> samples;
  for (const auto& [id, T] : bentX17().truth) samples.push_back({id, T.R.transpose() * up.normalized()});
  return samples;
}

Eigen::Vector3d randomUp(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return test::randomVector([&] { return normal(random); }).normalized();
}

/// A patch's directions without any solver: only what coverageOf looks at.
Reconstruction withGravity(const Ups& ups) {
  test::ResultBuilder builder;
  builder.patch(7).cell(7).poses(ups.size());
  for (const Eigen::Vector3d& up : ups) builder.gravity(up.normalized());
  Reconstruction result = builder.build();
  result.assessment.remedy = Remedy::TakePose;
  return result;
}

TEST(CoverageDisc, MiddleIsTheOriginCellsFrontAndTheRimIsLevel) {
  EXPECT_EQ(onDisc(Eigen::Vector3d::UnitZ()).side, Hemisphere::Front);
  EXPECT_LT(onDisc(Eigen::Vector3d::UnitZ()).at.norm(), 1e-12);
  EXPECT_EQ(onDisc(-Eigen::Vector3d::UnitZ()).side, Hemisphere::Back);
  EXPECT_LT(onDisc(-Eigen::Vector3d::UnitZ()).at.norm(), 1e-12);
  EXPECT_LT((onDisc(Eigen::Vector3d::UnitX()).at - Eigen::Vector2d(1, 0)).norm(), 1e-12);
  EXPECT_LT((onDisc(-Eigen::Vector3d::UnitY()).at - Eigen::Vector2d(0, -1)).norm(), 1e-12);
  EXPECT_NEAR(discRadius(90 * kDegree), 1, 1e-12);
}

TEST(CoverageDisc, WhatLeavesTheFrontOnTheRightEntersTheBackOnTheLeft) {
  const DiscPoint front = onDisc(Eigen::Vector3d(1, 0.2, 1e-6).normalized());
  const DiscPoint back = onDisc(Eigen::Vector3d(1, 0.2, -1e-6).normalized());
  EXPECT_EQ(back.side, Hemisphere::Back);
  EXPECT_NEAR(front.at.x(), -back.at.x(), 1e-5);
  EXPECT_NEAR(front.at.y(), back.at.y(), 1e-5);
}

TEST(CoverageDisc, CircleOfAnAngleIsWhereDirectionsOfThatAngleLieAndHoldsTheirShareOfTheSphere) {
  for (const double angle : {10 * kDegree, 45 * kDegree, 80 * kDegree}) {
    const Eigen::Vector3d up(std::sin(angle), 0, std::cos(angle));
    EXPECT_NEAR(onDisc(up).at.norm(), discRadius(angle), 1e-12);
    EXPECT_NEAR(std::pow(discRadius(angle), 2), 1 - std::cos(angle), 1e-12);
  }
}

TEST(PoseCoverage, OfAnEmptySkinIsEmpty) {
  const Reconstruction empty = test::ResultBuilder().build();
  const PoseCoverage coverage = coverageOf(empty);
  EXPECT_TRUE(coverage.seen.empty());
  EXPECT_FALSE(coverage.missing);
  EXPECT_FALSE(describeNextPose({}, empty));
  EXPECT_FALSE(currentUp(empty, readings(Eigen::Vector3d::UnitZ())));
}

TEST(PoseCoverage, SingularValuesSayWhichDirectionIsMissing) {
  struct Case {
    Ups ups;
    Eigen::Vector3d values;
    EdgeQuality quality;
    int missing;  ///< 0: nothing
  };
  const double t = 50 * kDegree;
  for (const Case& c : {
           Case{{}, {0, 0, 0}, EdgeQuality::Undefined, 1},
           Case{{{0, 0, 1}}, {1, 0, 0}, EdgeQuality::Partially, 2},
           Case{{{0, 0, 1}, {0, 0, -1}, {0, 0, 1}}, {3, 0, 0}, EdgeQuality::Partially, 2},
           Case{{{0, 0, 1}, {std::sin(t), 0, std::cos(t)}},
                {1 + std::cos(t), 1 - std::cos(t), 0},
                EdgeQuality::Partially,
                2},
           Case{{{1, 0, 0}, {0, 1, 0}}, {1, 1, 0}, EdgeQuality::Fully, 3},
           Case{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {4.0 / 3, 4.0 / 3, 4.0 / 3}, EdgeQuality::Over, 0},
       }) {
    const PoseCoverage coverage = coverageOf(withGravity(c.ups));
    EXPECT_THAT(coverage.singular_values, VectorNear(c.values, 1e-12));
    EXPECT_EQ(coverage.quality, c.quality) << c.values.transpose();
    EXPECT_EQ(coverage.seen.size(), c.ups.size());
    ASSERT_EQ(coverage.missing ? coverage.missing->which : 0, c.missing) << c.values.transpose();
    if (!coverage.missing) continue;
    EXPECT_EQ(coverage.missing->facing.cell, CellId(7));
    EXPECT_EQ(coverage.missing->facing.facing == Facing::Ceiling, coverage.missing->up_o.z() > 0.9);
    double seen_along_it = 0;
    for (const Eigen::Vector3d& up : c.ups) seen_along_it += std::pow(up.dot(coverage.missing->up_o), 2);
    EXPECT_NEAR(seen_along_it, c.values[c.missing - 1], 1e-12);
    EXPECT_NEAR(coverage.missing->value, c.values[c.missing - 1], 1e-12);
  }
}

TEST(PoseCoverage, OneMorePoseFillsWhatIsMissingOnlyFarFromTheOthers) {
  const PoseCoverage one = coverageOf(withGravity({{0, 0, 1}}));
  EXPECT_TRUE(fillsMissing(one, {1, 0, 0}));
  EXPECT_FALSE(fillsMissing(one, {0, 0, -1}));
  EXPECT_FALSE(fillsMissing(one, {0.5, 0, 1}));
  const PoseCoverage two = coverageOf(withGravity({{0, 0, 1}, {1, 0, 0}}));
  EXPECT_TRUE(fillsMissing(two, {0, -2, 0}));
  EXPECT_FALSE(fillsMissing(two, {1, 0, 1})) << "in the plane of the two";
  const PoseCoverage all = coverageOf(withGravity({{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(fillsMissing(all, {0, 1, 0})) << "nothing is missing";
}

TEST(PoseCoverage, DisabledPosesAreShownFromTheirReadingsAndCountForNothing) {
  Session session = bentX17().session(orthogonalUps(3));
  const auto before = reconstruct(*session.snapshot());
  session.setPoseDisabled(1, true);
  const auto result = reconstruct(*session.snapshot());
  std::vector<std::shared_ptr<const PoseCapture>> captures;
  for (const SessionPose& pose : session.poses()) captures.push_back(pose.capture);
  const PoseCoverage coverage = coverageOf(*result, captures);
  ASSERT_EQ(coverage.seen.size(), 3U);
  EXPECT_EQ(coverage.enabled, 2U);
  EXPECT_FALSE(coverage.seen[1].enabled);
  const Eigen::Vector3d was = coverageOf(*before).seen[1].up_o;
  EXPECT_LT(toDegrees(angleBetween(coverage.seen[1].up_o, was)), 5);
  EXPECT_NEAR(coverage.singular_values.sum(), 2, 1e-9);

  const PoseCoverage without = coverageOf(*result);
  EXPECT_EQ(without.seen.size(), 2U);
  EXPECT_EQ(without.unplaced, std::vector<PoseId>{PoseId(2)});
}

TEST(CurrentUp, IsExactForExactReadings) {
  const auto result = solved(orthogonalUps(4));
  // The patch frame is the origin cell's.
  const Eigen::Matrix3d R_o_b = bentX17().truth.at(result->patches[0].origin).R.transpose();
  std::mt19937 random(2);
  for (int k = 0; k < 20; ++k) {
    const Eigen::Vector3d up = randomUp(random);
    const auto found = currentUp(*result, readings(up));
    ASSERT_TRUE(found);
    EXPECT_LT(toDegrees(angleBetween(*found, R_o_b * up)), 0.1);
  }
}

TEST(CurrentUp, ABrokenMinorityHasNoSay) {
  const auto result = solved(orthogonalUps(4));
  const Eigen::Vector3d up(0.3, -0.5, 0.8);
  const auto right = currentUp(*result, readings(up));
  std::vector<CellSample> broken = readings(up);
  broken[3].acceleration_g = {0, 0, 0};
  broken[5].acceleration_g *= -1;
  broken[8].acceleration_g = {2, 2, 2};
  const auto found = currentUp(*result, broken);
  ASSERT_TRUE(right && found);
  EXPECT_LT(toDegrees(angleBetween(*right, *found)), 2);
}

TEST(CurrentUp, IsAbsentWhereReadingsContradictOrThereAreNone) {
  const auto result = solved(orthogonalUps(3));
  EXPECT_FALSE(currentUp(*result, std::vector<CellSample>{}));
  EXPECT_FALSE(currentUp(*result, std::vector<CellSample>{{CellId(999), Eigen::Vector3d::UnitZ()}}));
  std::vector<CellSample> mixed = readings(Eigen::Vector3d::UnitZ());
  for (std::size_t k = 0; k < mixed.size(); k += 2) mixed[k].acceleration_g *= -1;
  EXPECT_FALSE(currentUp(*result, mixed));
}

TEST(PoseAdvisor, FirstTwoAreAboutARightAngleApart) {
  const Eigen::Vector3d first = Eigen::Vector3d(0.2, 0.3, 0.9).normalized();
  const PoseAdvice advice = adviseNextPose(kModel, {first});
  EXPECT_NEAR(toDegrees(angleBetween(advice.up, first)), 90, 15);
  EXPECT_LT(advice.sigma_then_rad, advice.sigma_now_rad);
  EXPECT_LT(std::abs(adviseNextPose(kModel, {Eigen::Vector3d::UnitX()}).up.x()), 0.5);
}

TEST(PoseAdvisor, FirstFourAreNotInAPlane) {
  std::vector<Eigen::Vector3d> seen = {Eigen::Vector3d::UnitZ()};
  while (seen.size() < 4) seen.push_back(adviseNextPose(kModel, seen).up);
  Eigen::Matrix3Xd differences(3, 3);
  for (Eigen::Index k = 0; k < 3; ++k) differences.col(k) = seen[static_cast<std::size_t>(k) + 1] - seen[0];
  EXPECT_GT(std::abs(differences.determinant()), 0.5) << "a tetrahedron's edges, not a plane's";
}

TEST(PoseAdvisor, EveryAdvisedPoseHelpsLessThanTheOneBefore) {
  std::vector<Eigen::Vector3d> seen = {Eigen::Vector3d::UnitZ()};
  double sigma = adviseNextPose(kModel, seen).sigma_now_rad;
  for (int k = 0; k < 6; ++k) {
    const PoseAdvice advice = adviseNextPose(kModel, seen);
    EXPECT_LT(advice.sigma_then_rad, sigma);
    sigma = advice.sigma_then_rad;
    seen.push_back(advice.up);
  }
  EXPECT_LT(toDegrees(sigma), 2.5);
}

TEST(PoseAdvisor, StatesWhatAFitOfTheReadingsLeavesOpen) {
  const Ups ups = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d(1, 2, -2) / 3, Eigen::Vector3d(-2, 1, 2) / 3};
  std::vector<CellReading> readings;
  for (const Eigen::Vector3d& up : ups) readings.push_back({readings.size(), up, std::pow(0.003, 2)});
  AccelerometerFit fit;
  fitAccelerometer(AccelerometerPrior(kModel.accelerometer.ofUnknownLot()), readings, ups, {}, fit);
  const double prior_sq =
      (std::pow(kModel.bend_sigma_rad, 2) + std::pow(kModel.twist_sigma_rad, 2) + std::pow(kModel.yaw_sigma_rad, 2)) /
      3;
  const Eigen::Matrix3d information = attitudeInformation(fit, ups) / 2 + Eigen::Matrix3d::Identity() / prior_sq;
  EXPECT_NEAR(adviseNextPose(kModel, ups).sigma_now_rad, std::sqrt(information.inverse().trace() / 3), 1e-9);
}

TEST(Directions, LieAlongOneLineUpToFifteenDegrees) {
  const auto tilted = [](double degrees) {
    return Eigen::Vector3d(std::sin(degrees * kDegree), 0, std::cos(degrees * kDegree));
  };
  EXPECT_FALSE(lieAlongOneLine({}));
  EXPECT_FALSE(lieAlongOneLine(Ups{tilted(0)})) << "one direction is no choice";
  EXPECT_TRUE(lieAlongOneLine(Ups{tilted(0), -tilted(0), tilted(0)}));
  EXPECT_TRUE(lieAlongOneLine(Ups{tilted(-14), -tilted(14)}));
  EXPECT_FALSE(lieAlongOneLine(Ups{tilted(-16), -tilted(16)}));
  EXPECT_FALSE(lieAlongOneLine(Ups{tilted(0), tilted(90)}));
}

TEST(PoseAdvisor, SaysWhichCellFacesWhere) {
  const auto result = reconstruct(*bentX17().session(orthogonalUps(2)).snapshot());
  PoseAdvice advice;
  advice.up = result->find(CellId(9)).cell->T_o_u.R.col(2);
  EXPECT_EQ(adviceText(advice, *result).english(), "Turn the part so that cell 9 faces the ceiling.");
  advice.up = -advice.up;
  EXPECT_EQ(adviceText(advice, *result).english(), "Turn the part so that cell 9 faces the floor.");
}

TEST(NextPose, SaysWhatEachPoseAdds) {
  Ups ups;
  const auto next = [&] {
    const Reconstruction result = withGravity(ups);
    return describeNextPose(adviseNextPose(kModel, ups), result).value();
  };
  EXPECT_EQ(next().gain, PoseGain::First);
  EXPECT_FALSE(next().turn_rad) << "nobody knows where the part is";
  ups.emplace_back(0, 0, 1);
  EXPECT_EQ(next().gain, PoseGain::SecondDirection);
  EXPECT_GT(toDegrees(next().turn_rad.value()), 45);
  ups.emplace_back(0, 0, -1);
  EXPECT_EQ(next().gain, PoseGain::SecondDirection) << "the opposite one is no second direction";
  EXPECT_TRUE(next().worthwhile);
  ups.back() = {1, 0, 0};
  EXPECT_EQ(next().gain, PoseGain::OutOfPlane);
  ups.emplace_back(0, 1, 0);
  Reconstruction three = withGravity(ups);
  PoseAdvice opposite;
  opposite.up = {-1, 0, 0};
  EXPECT_EQ(describeNextPose(opposite, three)->gain, PoseGain::Opposite);
  EXPECT_EQ(describeNextPose(opposite, three)->opposite_of, PoseId(2));
  opposite.up = Eigen::Vector3d(1, 1, 1).normalized();
  EXPECT_EQ(describeNextPose(opposite, three)->gain, PoseGain::Further);
}

TEST(NextPose, IsWorthwhileWhereTheAssessmentSaysSo) {
  Reconstruction result = withGravity({{0, 0, 1}, {1, 0, 0}});
  const PoseAdvice advice = adviseNextPose(kModel, {{0, 0, 1}, {1, 0, 0}});
  for (const auto& [remedy, worthwhile] : {std::pair(Remedy::Nothing, false), std::pair(Remedy::CheckSkin, false),
                                           std::pair(Remedy::TakePose, true), std::pair(Remedy::RetakePoses, true)}) {
    result.assessment.remedy = remedy;
    EXPECT_EQ(describeNextPose(advice, result)->worthwhile, worthwhile) << remedyName(remedy);
    EXPECT_EQ(coverageOf(result).missing.has_value(), remedy == Remedy::TakePose) << remedyName(remedy);
  }
}

TEST(NextPose, TurnsFromWhereThePartIsNow) {
  const Reconstruction result = withGravity({{0, 0, 1}});
  PoseAdvice advice;
  advice.up = Eigen::Vector3d::UnitX();
  EXPECT_NEAR(toDegrees(describeNextPose(advice, result)->turn_rad.value()), 90, 1e-9);
  const Eigen::Vector3d now(std::sqrt(0.5), 0, std::sqrt(0.5));
  EXPECT_NEAR(toDegrees(describeNextPose(advice, result, now)->turn_rad.value()), 45, 1e-9);
}

TEST(PoseLabel, SaysWhatTheOriginCellFaces) {
  EXPECT_EQ(poseLabel({0, 0, 1}).english(), "facing ceiling");
  EXPECT_EQ(poseLabel({0, 0, -1}).english(), "facing floor");
  EXPECT_EQ(poseLabel({0, 1, 0}).english(), "facing wall, +y up");
  EXPECT_EQ(poseLabel({-1, 0, 0}).english(), "facing wall, -x up");
  EXPECT_EQ(poseLabel(Eigen::Vector3d(1, 0, 1).normalized()).english(), "tilted up, +x up");
  EXPECT_EQ(poseLabel(Eigen::Vector3d(0, -1, -1).normalized()).english(), "tilted down, -y up");
}

TEST(PoseLabel, OfACaptureIsWhatItsOriginReads) {
  const Reconstruction result = withGravity({});
  const CellId origin = largestPatch(result)->origin;
  PoseCapture capture;
  EXPECT_EQ(poseLabel(result, capture).english(), "") << "the origin was not heard";
  const Eigen::Matrix3d R_a_u = result.model->accelerometer.T_u_a.R.transpose();
  capture.samples = {{CellId(999), {0, 0, 1}, {}, 1}, {origin, R_a_u * Eigen::Vector3d(0, 0, -1.05), {}, 1}};
  EXPECT_EQ(poseLabel(result, capture).english(), "facing floor");
  capture.samples[1].mean_g *= 0.01;
  EXPECT_EQ(poseLabel(result, capture).english(), "") << "no gravity";
  Reconstruction none;
  EXPECT_EQ(poseLabel(none, capture).english(), "");
}

}  // namespace
}  // namespace hexoderm
