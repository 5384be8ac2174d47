// Whatever a session holds, everything that is said of its result agrees: verdict, findings, advice, directions, exit
// code and file. The rules are the table "What agrees with what" in core/hexoderm/solve/README.md.

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/solve/metrics/assess.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/matchers.h"
#include "tests/support/random_session.h"
#include "tests/support/slow_build.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

#include <thread>

namespace hexoderm {
namespace {

void expectAgreement(const Session& session, const Reconstruction& r) {
  const Assessment& a = r.assessment;
  const std::string reason = a.reason.english();
  ASSERT_THAT(r, IsFinite());
  ASSERT_FALSE(reason.empty());
  ASSERT_FALSE(a.next_action.empty());

  // The level and what limits it.
  const bool good = a.level == VerdictLevel::Good;
  EXPECT_EQ(good, a.limit == Limit::Nothing);
  if (good) {
    EXPECT_LE(*a.orientation_95_rad, r.options.goal.orientation_rad);
    EXPECT_LE(*a.position_95_m, r.options.goal.position_m);
    EXPECT_TRUE(r.patches.size() == 1 || findingOf(r, FindingCode::LinkSetAside) != nullptr) << "a joint was said";
    EXPECT_EQ(worstFinding(r), nullptr);
    EXPECT_EQ(a.remedy, Remedy::Nothing);
  }
  if (r.cellCount() > 1 && std::ranges::any_of(r.poses, &PoseSummary::enabled)) {
    std::size_t measured = 0;
    std::size_t alone = 0;
    for (const PatchReconstruction& patch : r.patches) {
      measured +=
          static_cast<std::size_t>(std::ranges::count(patch.cells, PlacedBy::Samples, &CellPlacement::placed_by));
      if (patch.cells.size() == 1) ++alone;
    }
    EXPECT_EQ(a.level == VerdictLevel::Failed, 2 * alone > r.cellCount() || 2 * measured < r.cellCount()) << reason;
  }
  if (!a.isUsable()) {
    EXPECT_NE(a.remedy, Remedy::Nothing) << "what is of no use is not to be exported";
  }
  if (a.level != VerdictLevel::Failed && r.patches.size() > 1) {
    EXPECT_THAT(reason, HasSubstr(std::to_string(r.patches.size()) + " patches"));
  }
  const bool is_refuted =
      std::ranges::any_of(r.findings, [](const Finding& finding) { return refutesModel(finding.code); });
  if (is_refuted) {
    EXPECT_TRUE(a.level == VerdictLevel::NotTrusted || a.level == VerdictLevel::Failed) << reason;
  }
  if (a.level == VerdictLevel::NotTrusted) {
    EXPECT_FALSE(a.position_95_m || a.orientation_95_rad);
    EXPECT_THAT(reason, StartsWith("Not to be trusted: "));
    EXPECT_EQ(a.limit, Limit::Findings);
    EXPECT_TRUE(std::ranges::any_of(r.patches, [](const PatchReconstruction& patch) {
      return std::ranges::none_of(patch.cells, [](const CellPlacement& cell) { return cell.cov_t_r.has_value(); });
    }));
  } else if (a.level != VerdictLevel::Failed) {
    Uncertainty95 worst;
    for (const PatchReconstruction& patch : r.patches) {
      const Uncertainty95 of_patch = worstUncertainty(patch);
      worst.position_m = std::max(worst.position_m, of_patch.position_m);
      worst.orientation_rad = std::max(worst.orientation_rad, of_patch.orientation_rad);
    }
    EXPECT_EQ(*a.position_95_m, worst.position_m);
    EXPECT_EQ(*a.orientation_95_rad, worst.orientation_rad);
    const Goal& goal = r.options.goal;
    EXPECT_EQ(a.level == VerdictLevel::Coarse,
              a.isUsable() && !meets(worst, {3 * goal.position_m, 3 * goal.orientation_rad}) && r.cellCount() > 1);
  }

  // Advice and directions.
  EXPECT_EQ(findingOf(r, FindingCode::TooFewDirections) != nullptr,
            a.level == VerdictLevel::NotEnough && a.limit == Limit::Directions);
  const PoseCoverage coverage = coverageOf(r);
  if (coverage.missing) {
    EXPECT_EQ(a.remedy, Remedy::TakePose) << "a direction is missing, and enough were taken";
  }
  std::vector<Eigen::Vector3d> seen;
  for (const GravityDirection& gravity : largestPatch(r)->gravity) seen.push_back(gravity.g_o);
  const std::optional<NextPose> next = describeNextPose(adviseNextPose(*r.model, seen), r);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->worthwhile, a.wantsPose());

  // Readings that lack.
  EXPECT_EQ(a.remedy == Remedy::RetakePoses, a.limit == Limit::Readings);
  EXPECT_EQ(a.remedy == Remedy::RetakePoses, !a.retake.empty());
  EXPECT_EQ(a.limit == Limit::Readings, !a.limiting_cells.empty());
  for (const PoseId pose : a.retake) {
    const auto summary = std::ranges::find(r.poses, pose, &PoseSummary::pose);
    ASSERT_NE(summary, r.poses.end());
    EXPECT_TRUE(summary->enabled);
    EXPECT_LT(summary->cells_measured, r.cellCount());
  }
  for (const CellId cell : a.limiting_cells) {
    EXPECT_EQ(r.find(cell).cell->placed_by, PlacedBy::Samples);
    EXPECT_TRUE(std::ranges::any_of(session.poses(), [&](const SessionPose& pose) {
      return std::ranges::count(pose.capture->samples, cell, &GravitySample::cell) > 0;
    }));
  }

  // The origin measures, where any cell of its patch does.
  for (const PatchReconstruction& patch : r.patches) {
    const bool any =
        std::ranges::any_of(patch.cells, [](const CellPlacement& cell) { return cell.placed_by == PlacedBy::Samples; });
    EXPECT_EQ(patch.findCell(patch.origin)->placed_by == PlacedBy::Samples, any);
  }

  // The file says the same.
  const auto reread = parseCalibrationJson(calibrationToJson(r), "test");
  EXPECT_EQ(reread->assessment.level, a.level);
  EXPECT_EQ(reread->assessment.limit, a.limit);
  EXPECT_EQ(reread->assessment.remedy, a.remedy);
  EXPECT_EQ(reread->assessment.retake, a.retake);
  EXPECT_EQ(reread->assessment.limiting_cells, a.limiting_cells);
  EXPECT_EQ(reread->assessment.reason.english(), reason);
  EXPECT_EQ(reread->assessment.next_action.english(), a.next_action.english());
}

TEST(Agreement, OfAllThatIsSaidInFiveThousandRandomSessions) {
  constexpr std::uint64_t kSessions = test::kSlowBuild ? 200 : 5000;
  std::array<std::size_t, 6> levels{};
  std::array<std::size_t, 4> remedies{};
  std::array<std::size_t, 8> limits{};
  for (std::uint64_t seed = 1; seed <= kSessions && !HasFailure(); ++seed) {
    SCOPED_TRACE("session " + std::to_string(seed));
    const Session session = test::RandomSession(seed).draw();
    const auto result = reconstruct(*session.snapshot(), test::by(seed % 5 == 0 ? Solver::Tree : Solver::Global));
    ASSERT_NO_FATAL_FAILURE(expectAgreement(session, *result)) << result->assessment.reason;
    if (HasFailure()) ADD_FAILURE() << result->assessment.reason << " | " << result->assessment.next_action;
    ++levels.at(static_cast<std::size_t>(result->assessment.level));
    ++remedies.at(static_cast<std::size_t>(result->assessment.remedy));
    ++limits.at(static_cast<std::size_t>(result->assessment.limit));
  }
  if (test::kSlowBuild) return;
  for (const std::size_t count : levels) EXPECT_GT(count, 20) << "every level was drawn";
  for (const std::size_t count : remedies) EXPECT_GT(count, 20) << "every remedy was drawn";
  for (std::size_t k = 0; k < limits.size(); ++k) {
    EXPECT_GT(limits[k], 5) << limitName(static_cast<Limit>(k)) << " was drawn";
  }
}

}  // namespace
}  // namespace hexoderm
