// hexoderm-reproduce with so few skins that it is quick: its form, and what few skins can tell.

#include "tests/app/cli/cli_program.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Reproduce : public Cli {
 protected:
  Reproduce() { program_ = HEXODERM_REPRODUCE; }
};

/// JSON has no words for NaN and infinity: they are written as null, which only some keys may be.
void expectFinite(const nlohmann::json& row, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    ASSERT_TRUE(row.at(key).is_number()) << key << " of " << row;
    EXPECT_TRUE(std::isfinite(row.at(key).get<double>())) << key << " of " << row;
  }
}

TEST_F(Reproduce, PrintsThePapersMetricsBesideOurs) {
  const std::string text = outputOf("--quiet --seeds 3 --only paper");
  EXPECT_THAT(text, AllOf(HasSubstr("-0.30"), HasSubstr("1.62"), HasSubstr("10.46"), HasSubstr("4.71"),
                          HasSubstr("20 mg"), HasSubstr("60 mg"), HasSubstr("100 mg"), HasSubstr("imulated")));
  const auto json = jsonOf("--quiet --seeds 3 --only paper --json");
  EXPECT_EQ(json.at("simulated"), true);
  EXPECT_FALSE(json.contains("accuracy"));
  ASSERT_EQ(json.at("paper").at("rows").size(), 12);
  for (const auto& row : json.at("paper").at("rows")) {
    for (const std::string method : {"papers_method", "global"}) {
      EXPECT_EQ(row.at(method).at("skins"), 3) << row;
      expectFinite(row.at(method), {"p5", "median", "p95"});
    }
  }
}

TEST_F(Reproduce, PlacesOnEveryLinkAreCounted) {
  const auto json = jsonOf("--quiet --seeds 1 --only place --json");
  const auto& rows = json.at("place").at("rows");
  ASSERT_EQ(rows.size(), 3 * 2 + 1);
  for (const auto& row : rows) {
    EXPECT_EQ(row.at("among").at("of"), 1) << row;
    expectFinite(row, {"candidates_mean", "error_median_mm", "error_95_mm", "nees"});
  }
}

TEST_F(Reproduce, AccuracyTableIsWholeAndTheGlobalSolverBeatsThePapersMethod) {
  const auto json = jsonOf("--quiet --seeds 2 --only accuracy --json");
  const auto& rows = json.at("accuracy").at("rows");
  // 4 of orientation; per law 2 of X17, 3 of the ring twice, 2 of the closed one, 1 of 1,000 cells.
  ASSERT_EQ(rows.size(), 4 + 2 * (2 + 2 * 3 + 2 + 1));
  bool compared = false;
  for (const auto& row : rows) {
    EXPECT_GE(row.at("skins"), 1) << row;
    const bool about_s = !row.at("fit").is_null() && row.at("papers_method").is_null();
    const bool known_orientations = row.at("fit").is_null();
    if (!about_s && !known_orientations) expectFinite(row, {"papers_method", "matching", "mismatching", "fit"});
    if (row.at("figure") != "X17: orientation" || row.at("poses") != 3) continue;
    compared = true;
    EXPECT_LT(row.at("fit").get<double>(), row.at("papers_method").get<double>());
    EXPECT_LT(row.at("matching").get<double>(), row.at("papers_method").get<double>());
  }
  EXPECT_TRUE(compared);
}

TEST_F(Reproduce, UncertaintyAndDetectionAreCounted) {
  const auto uncertainty = jsonOf("--quiet --seeds 1 --only uncertainty --json").at("uncertainty");
  EXPECT_EQ(uncertainty.at("rows").size(), 4 * 2 * 2 * 3);
  EXPECT_EQ(uncertainty.at("wrong_prior").size(), 4);
  for (const auto& row : uncertainty.at("rows")) {
    expectFinite(row, {"nees_position", "nees_orientation"});
    EXPECT_GT(row.at("nees_position").get<double>(), 0);
  }
  const auto detection = jsonOf("--quiet --seeds 2 --only detection --json").at("detection");
  EXPECT_EQ(detection.at("sessions"), 2);
  EXPECT_EQ(detection.at("rows").size(), 11);
  for (const auto& row : detection.at("rows")) expectFinite(row, {"false_per_link_percent", "false_per_cell_percent"});
}

TEST_F(Reproduce, FaultsOfEveryKindAreCountedWithIntervals) {
  const auto json = jsonOf("--quiet --seeds 3 --only faults --json").at("faults");
  EXPECT_EQ(json.at("healthy").size(), 3);
  for (const auto& row : json.at("healthy")) {
    EXPECT_EQ(row.at("sessions"), 1) << row;
    EXPECT_EQ(row.at("alarms").at("count"), 0) << row;
  }
  ASSERT_GE(json.at("rows").size(), 40);
  for (const auto& row : json.at("rows")) {
    for (const std::string share : {"found", "named_right", "silently_wrong"}) {
      EXPECT_EQ(row.at(share).at("of"), 3) << row;
      expectFinite(row.at(share), {"percent", "low_percent", "high_percent"});
    }
    EXPECT_GT(row.at("times_healthy_cpu_median").get<double>(), 0) << row;
    const std::string fault = row.at("fault");
    if (fault == "dead" || fault == "no-samples" || fault == "cable") {
      EXPECT_EQ(row.at("named_right").at("count"), 3) << row;
      EXPECT_EQ(row.at("silently_wrong").at("count"), 0) << row;
    }
  }
}

TEST_F(Reproduce, LotsAreBesideIndependentPriorsAndTheBound) {
  const auto json = jsonOf("--quiet --seeds 2 --only lots --json").at("lots");
  ASSERT_EQ(json.at("rows").size(), 4 * 12 * 4);  // skins, lots, poses
  for (const auto& row : json.at("rows")) {
    expectFinite(row, {"orientation_deg", "orientation_independent_priors_deg", "bound_rms_deg", "nees_position",
                       "nees_orientation"});
    EXPECT_GT(row.at("orientation_rms_over_bound").get<double>(), 0.5) << row;
    EXPECT_LT(row.at("orientation_rms_over_bound").get<double>(), 1.5) << row;
    const bool is_independent =
        row.at("offset_variance_shared_percent") == 0 && row.at("scale_shared_sigma_percent") == 0;
    EXPECT_EQ(row.at("orientation_deg") == row.at("orientation_independent_priors_deg"), is_independent) << row;
  }
  EXPECT_EQ(json.at("few_poses").at(0).at("poses"), 2);
  ASSERT_EQ(json.at("healthy").size(), 12 * 2);
  for (const auto& row : json.at("healthy")) EXPECT_EQ(row.at("accused").at("of"), 20 * 17) << row;
}

TEST_F(Reproduce, HelpHasAnExampleAndWrongUsageIsRefused) {
  EXPECT_THAT(outputOf("--help"), HasSubstr("\n  hexoderm-reproduce --seeds 200"));
  EXPECT_THAT(complaint("--seeds 0", 2), HasSubstr("--seeds: expected a whole number from 1 to 100000, found \"0\""));
  EXPECT_EQ(run("--only nothing").exit_code, 2);
}

TEST_F(Reproduce, TextHasEveryPart) {
  EXPECT_THAT(
      outputOf("--quiet --seeds 1"),
      AllOf(HasSubstr("The paper's two experiments"), HasSubstr("Accuracy on simulated skins"),
            HasSubstr("Stated uncertainty"), HasSubstr("Chips of one lot"), HasSubstr("What is broken is found"),
            HasSubstr("Faults of every kind"), HasSubstr("By hand"), Not(HasSubstr("nan")), Not(HasSubstr("inf "))));
}

TEST_F(Reproduce, ChecksOfCalibrationsAreCountedWithIntervals) {
  const std::string text = outputOf("--quiet --seeds 3 --only check");
  EXPECT_THAT(text, AllOf(HasSubstr("turned by 10 deg"), HasSubstr("offset drifted by 60 mg"), HasSubstr("healthy"),
                          HasSubstr("imulated")));
  const auto json = jsonOf("--quiet --seeds 3 --only check --json");
  EXPECT_FALSE(json.contains("detection"));
  for (const auto& row : json.at("check").at("rows")) {
    expectFinite(row.at("blamed_per_cell"), {"percent", "low_percent", "high_percent"});
    if (row.at("change").get<std::string>().starts_with("healthy")) {
      EXPECT_TRUE(row.at("found").is_null());
      EXPECT_EQ(row.at("blamed_per_cell").at("of"), 3 * 17);
      continue;
    }
    expectFinite(row.at("found"), {"percent", "low_percent", "high_percent"});
    EXPECT_EQ(row.at("found").at("of"), 3);
    if (row.at("reached").is_null()) continue;
    EXPECT_EQ(row.at("found").at("percent"), 100) << row;
  }
}

}  // namespace
}  // namespace hexoderm
