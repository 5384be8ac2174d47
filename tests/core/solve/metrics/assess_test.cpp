#include "hexoderm/solve/metrics/assess.h"

#include "tests/support/matchers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

Matrix6d covarianceOf(const Uncertainty95& spread) {
  constexpr double kSigmas = 1.96;
  Matrix6d covariance = Matrix6d::Zero();
  covariance.topLeftCorner<3, 3>().diagonal().setConstant(std::pow(spread.position_m / kSigmas, 2));
  covariance.bottomRightCorner<3, 3>().diagonal().setConstant(std::pow(spread.orientation_rad / kSigmas, 2));
  return covariance;
}

/// A patch of three cells, the third of which is the worst, seen from three square directions.
PatchReconstruction patchWith(const Uncertainty95& worst, std::uint32_t first = 1) {
  PatchReconstruction patch;
  patch.origin = CellId(first);
  for (std::uint32_t k = 0; k < 3; ++k) {
    CellPlacement& cell = patch.cells.emplace_back();
    cell.cell = CellId(first + k);
    cell.cov_t_r = covarianceOf({worst.position_m * k / 2, worst.orientation_rad * k / 2});
    patch.gravity.push_back({PoseId(k + 1), Eigen::Vector3d::Unit(k), 0.01});
  }
  return patch;
}

Reconstruction resultWith(const Uncertainty95& worst) {
  Reconstruction result;
  result.model = std::make_shared<const CellModel>(builtInCellModel("hex-bma150"));
  result.patches = {patchWith(worst)};
  for (std::uint32_t k = 1; k <= 3; ++k) result.poses.emplace_back().pose = PoseId(k);
  return result;
}

constexpr Uncertainty95 kPrecise{1 * kMillimetre, 1 * kDegree};
constexpr Uncertainty95 kRough{2 * kMillimetre, 5 * kDegree};
constexpr Uncertainty95 kCoarse{2 * kMillimetre, 7 * kDegree};
constexpr Uncertainty95 kUseless{9 * kMillimetre, 40 * kDegree};

Forecast forecastOf(const Uncertainty95& now, double share_with_pose) {
  return {now, {now.position_m * share_with_pose, now.orientation_rad * share_with_pose}, now, {}, {}};
}

TEST(Assess, APreciseResultWithoutFindingsIsGoodAndAsksForNothing) {
  const Assessment assessment = assess(resultWith(kPrecise), {});
  EXPECT_THAT(assessment, IsVerdict(VerdictLevel::Good, Limit::Nothing, Remedy::Nothing));
  EXPECT_FALSE(assessment.wantsPose());
  EXPECT_NEAR(*assessment.orientation_95_rad, kPrecise.orientation_rad, 1e-6);
  EXPECT_NEAR(*assessment.position_95_m, kPrecise.position_m, 1e-8);
  EXPECT_EQ(assessment.next_action.english(), "Export.");
}

// A cell that is placed through its links is less sure than what is stated, and the sentence says so.
TEST(Assess, SaysWhichCellsTheStatedUncertaintyIsOf) {
  Reconstruction result = resultWith(kRough);
  EXPECT_THAT(assess(result, {}).reason.english(), HasSubstr("±2.0 mm, ±5.0° (95 %, worst: cell 3)"));
  CellPlacement unmeasured = result.patches[0].cells.back();
  unmeasured.cell = CellId(4);
  unmeasured.placed_by = PlacedBy::Links;
  unmeasured.cov_t_r = covarianceOf(kUseless);
  result.patches[0].cells.push_back(unmeasured);
  EXPECT_THAT(assess(result, {}).reason.english(), HasSubstr("±2.0 mm, ±5.0° (95 %, worst measured: cell 3)"));
}

TEST(WorstCells, AreTheLeastCertainInPositionAndInOrientationOfAllPatches) {
  Reconstruction result = resultWith(kRough);
  EXPECT_THAT(worstCells(result), ElementsAre(CellId(3)));
  // The worst position is elsewhere than the worst orientation.
  result.patches[0].cells[1].cov_t_r = covarianceOf({5 * kMillimetre, 1 * kDegree});
  EXPECT_THAT(worstCells(result), ElementsAre(CellId(2), CellId(3)));
  EXPECT_THAT(assess(result, {}).reason.english(), HasSubstr("±5.0 mm, ±5.0° (95 %, worst: cells 2 and 3)"));
  result.patches.push_back(patchWith(kUseless, 11));
  EXPECT_THAT(worstCells(result), ElementsAre(CellId(13)));
  // Measured cells only, as long as a patch has any.
  result.patches[1].cells[2].placed_by = PlacedBy::Links;
  EXPECT_THAT(worstCells(result), ElementsAre(CellId(2), CellId(12)));
}

TEST(WorstCells, AreNoneWhereNoUncertaintyIsStated) {
  Reconstruction result = resultWith(kRough);
  for (CellPlacement& cell : result.patches[0].cells) cell.cov_t_r.reset();
  EXPECT_THAT(worstCells(result), IsEmpty());
  EXPECT_THAT(assess(result, {}).reason.english(), Not(HasSubstr("worst")));
}

TEST(Assess, TheNumberOfPosesDoesNotMatter) {
  for (const Uncertainty95& spread : {kPrecise, kRough, kUseless}) {
    Reconstruction result = resultWith(spread);
    const Assessment three = assess(result, forecastOf(spread, 0.5));
    for (std::uint32_t k = 4; k <= 20; ++k) result.poses.emplace_back().pose = PoseId(k);
    EXPECT_THAT(assess(result, forecastOf(spread, 0.5)), IsVerdict(three.level, three.limit, three.remedy));
  }
}

TEST(Assess, APoseIsWantedOnlyWhereItIsForeseenToHelp) {
  const Reconstruction rough = resultWith(kRough);
  const Assessment helped = assess(rough, forecastOf(kRough, 0.5));
  EXPECT_THAT(helped, IsVerdict(VerdictLevel::Usable, Limit::Directions, Remedy::TakePose));
  EXPECT_THAT(helped.next_action.english(), HasSubstr("That should bring ±5.0° to about ±2.5°."));
  const Assessment not_helped = assess(rough, forecastOf(kRough, 0.95));
  EXPECT_THAT(not_helped, IsVerdict(VerdictLevel::Usable, Limit::Mould, Remedy::Nothing));
  EXPECT_THAT(not_helped.reason.english(), HasSubstr("in the mould"));
}

TEST(Assess, GainsInAPositionCountWhereItIsThePositionThatIsNotGood) {
  const Uncertainty95 far{8 * kMillimetre, 1 * kDegree};
  const Assessment helped = assess(resultWith(far), forecastOf(far, 0.5));
  EXPECT_EQ(helped.remedy, Remedy::TakePose);
  EXPECT_THAT(helped.next_action.english(), HasSubstr("±8.0 mm to about ±4.0 mm"));
  const Forecast turns_only{far, {far.position_m, 0.1 * kDegree}, far, {}, {}};
  EXPECT_EQ(assess(resultWith(far), turns_only).remedy, Remedy::Nothing);
}

TEST(Assess, ReadingsThatLackAreNamedAndTakenAgainWhereThatHelpsMost) {
  Forecast forecast = forecastOf(kUseless, 0.8);
  forecast.with_all_readings = kPrecise;
  forecast.lacking = {CellId(3)};
  forecast.retake = {PoseId(1), PoseId(2)};
  const Assessment assessment = assess(resultWith(kUseless), forecast);
  EXPECT_THAT(assessment, IsVerdict(VerdictLevel::NotEnough, Limit::Readings, Remedy::RetakePoses));
  EXPECT_TRUE(assessment.wantsPose());
  EXPECT_EQ(assessment.limiting_cells, forecast.lacking);
  EXPECT_EQ(assessment.retake, forecast.retake);
  EXPECT_THAT(assessment.reason.english(), HasSubstr("cell 3 can't be used in poses 1 and 2"));
  EXPECT_THAT(assessment.next_action.english(), HasSubstr("Take poses 1 and 2 again."));
  forecast.with_pose = {0.5 * kMillimetre, 0.5 * kDegree};
  EXPECT_EQ(assess(resultWith(kUseless), forecast).remedy, Remedy::TakePose);
}

TEST(Assess, TheGoalDecidesWhatIsGoodUsableAndCoarse) {
  EXPECT_EQ(assess(resultWith(kRough), {}).level, VerdictLevel::Usable);
  Reconstruction result = resultWith(kCoarse);
  const Assessment coarse = assess(result, {});
  EXPECT_EQ(coarse.level, VerdictLevel::Coarse);
  EXPECT_TRUE(coarse.isUsable());
  EXPECT_THAT(coarse.reason.english(), StartsWith("Coarse: ±2.0 mm, ±7.0°"));
  result.options.goal = {1 * kMillimetre, 3 * kDegree};
  EXPECT_EQ(assess(result, {}).level, VerdictLevel::Usable);
  result.options.goal = {2.1 * kMillimetre, 7.1 * kDegree};
  EXPECT_THAT(assess(result, {}), IsVerdict(VerdictLevel::Good, Limit::Nothing, Remedy::Nothing));
}

TEST(Assess, AFindingThatRefutesTheModelLeavesNothingToTrust) {
  Reconstruction result = resultWith(kPrecise);
  result.patches.push_back(patchWith(kPrecise, 11));
  result.findings = {
      makeFinding(FindingCode::ContradictsModel, Message::verbatim("The axes are wrong."), {CellId(1), CellId(2)})};
  result.assessment = assess(result, {});
  EXPECT_THAT(result.assessment, IsVerdict(VerdictLevel::NotTrusted, Limit::Findings, Remedy::CheckSkin));
  EXPECT_THAT(result.assessment.reason.english(), StartsWith("Not to be trusted: The axes are wrong."));
  EXPECT_FALSE(result.assessment.position_95_m || result.assessment.orientation_95_rad);
  EXPECT_FALSE(result.assessment.isUsable());
  withdrawUncertainties(result);
  EXPECT_FALSE(result.patches[0].cells[2].cov_t_r);
  EXPECT_TRUE(result.patches[1].cells[2].cov_t_r) << "another patch";
}

TEST(Assess, AThirdOfTheCellsAccusedIsNotToBeTrusted) {
  Reconstruction result = resultWith(kPrecise);
  result.patches.push_back(patchWith(kPrecise, 11));
  const auto accuse = [&](std::uint32_t cell) {
    result.findings.push_back(makeFinding(FindingCode::TurnedSensor, Message::verbatim("Turned."), {CellId(cell)}));
    return assess(result, {}).level;
  };
  EXPECT_EQ(accuse(2), VerdictLevel::Usable);
  EXPECT_EQ(accuse(3), VerdictLevel::NotTrusted) << "two of six";
}

TEST(Assess, ASkinThatFellApartWithoutAReasonIsNotToBeTrusted) {
  Reconstruction result = resultWith(kPrecise);
  result.patches.push_back(patchWith(kPrecise, 11));
  const auto split = [&](std::uint32_t links, FindingCode why) {
    result.patches[0].links.clear();
    for (std::uint32_t k = 0; k < links; ++k) {
      LinkEstimate& link = result.patches[0].links.emplace_back();
      link.source = {CellId(1 + k % 3), PortNumber(1 + k / 3)};
      link.target = {CellId(11 + k % 3), PortNumber(1 + k / 3)};
      link.muted_by = why;
    }
    return assess(result, {}).level;
  };
  EXPECT_EQ(split(3, FindingCode::ImplausibleYaw), VerdictLevel::Usable) << "a few links may be cables";
  EXPECT_EQ(split(4, FindingCode::ImplausibleYaw), VerdictLevel::NotTrusted);
  EXPECT_EQ(split(4, FindingCode::BodyPartBoundary), VerdictLevel::Good) << "a known joint is no missing link";
  EXPECT_THAT(assess(result, {}).reason.english(),
              HasSubstr("The 2 patches, which a joint or the robot holds together"));
}

TEST(Assess, PatchesThatAreOnTheRobotLackNoLink) {
  Reconstruction result = resultWith(kPrecise);
  result.patches.push_back(patchWith(kPrecise, 11));
  result.placements.resize(2);
  result.placements[0].origin = CellId(1);
  result.placements[0].place.emplace();
  result.placements[1].origin = CellId(11);
  EXPECT_EQ(assess(result, {}).limit, Limit::Patches) << "one of them is on no link";
  result.placements[1].place.emplace();
  EXPECT_THAT(assess(result, {}), IsVerdict(VerdictLevel::Good, Limit::Nothing, Remedy::Nothing));
}

TEST(Assess, SeveralPatchesThatNothingJoinsAreNeverGoodAndAreSaid) {
  Reconstruction result = resultWith(kPrecise);
  result.patches.push_back(patchWith(kPrecise, 10));
  const Assessment assessment = assess(result, {});
  EXPECT_THAT(assessment, IsVerdict(VerdictLevel::Usable, Limit::Patches, Remedy::Nothing));
  EXPECT_THAT(assessment.reason.english(), HasSubstr("No used link joins the 2 patches"));
}

TEST(Assess, CellsThatNothingJoinsAreAFailure) {
  Reconstruction result = resultWith(kPrecise);
  result.patches.clear();
  for (std::uint32_t k = 1; k <= 4; ++k) {
    PatchReconstruction& lone = result.patches.emplace_back();
    lone.origin = CellId(k);
    lone.cells.emplace_back().cell = CellId(k);
  }
  const Assessment all = assess(result, {});
  EXPECT_THAT(all, IsVerdict(VerdictLevel::Failed, Limit::NoSkin, Remedy::CheckSkin));
  EXPECT_FALSE(all.position_95_m) << "nothing is known, so nothing is stated";
  result.patches.push_back(patchWith(kPrecise, 10));
  EXPECT_EQ(assess(result, {}).level, VerdictLevel::Failed) << "four of seven lie alone";
  result.patches.erase(result.patches.begin());
  EXPECT_EQ(assess(result, {}).level, VerdictLevel::Usable) << "three of six";
}

TEST(Assess, AWarningKeepsAPreciseResultFromBeingGood) {
  Reconstruction result = resultWith(kPrecise);
  result.findings = {makeFinding(FindingCode::NoisySensor, Message::verbatim("Cell 2 is noisy."), {CellId(2)})};
  const Assessment assessment = assess(result, {});
  EXPECT_THAT(assessment, IsVerdict(VerdictLevel::Usable, Limit::Findings, Remedy::Nothing));
  EXPECT_THAT(assessment.reason.english(), HasSubstr("Cell 2 is noisy."));
  EXPECT_EQ(assessment.next_action.english(), "Look at the findings, then export.");
}

}  // namespace
}  // namespace hexoderm
