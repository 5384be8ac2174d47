#include "hexoderm/solve/faults/link_plausibility.h"

#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// `elastomer_deg`: deviation of the model's bend, twist and yaw alike; so wide that only the options' limits count.
std::vector<Finding> judge(double bend_deg, double twist_deg, double yaw_deg, double sigma_deg = 0,
                           double elastomer_deg = 100) {
  CellModel model = builtInCellModel("hex-bma150");
  model.bend_sigma_rad = model.twist_sigma_rad = model.yaw_sigma_rad = elastomer_deg * kDegree;
  const LinkAngles angles{twist_deg * kDegree, bend_deg * kDegree, yaw_deg * kDegree};
  const LinkAngles sigma{sigma_deg * kDegree, sigma_deg * kDegree, sigma_deg * kDegree};
  return judgeLinkAngles(angles, {CellId(5), PortNumber(2)}, {CellId(9), PortNumber(3)}, model, {}, sigma);
}

std::vector<FindingCode> codes(const std::vector<Finding>& findings) {
  std::vector<FindingCode> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

TEST(LinkPlausibility, AcceptsWhatASkinLinkCanDo) {
  EXPECT_THAT(judge(0, 0, 0), IsEmpty());
  EXPECT_THAT(judge(59.9, 0, 0), IsEmpty());
  EXPECT_THAT(judge(-59.9, 0, 0), IsEmpty());
  EXPECT_THAT(judge(0, 39.9, 0), IsEmpty());
  EXPECT_THAT(judge(0, 0, -39.9), IsEmpty());
}

TEST(LinkPlausibility, NamesTheAngleThatIsTooLarge) {
  EXPECT_THAT(codes(judge(60.1, 0, 0)), ElementsAre(FindingCode::ImplausibleBend));
  EXPECT_THAT(codes(judge(-60.1, 0, 0)), ElementsAre(FindingCode::ImplausibleBend));
  EXPECT_THAT(codes(judge(0, 40.1, 0)), ElementsAre(FindingCode::ImplausibleTwist));
  EXPECT_THAT(codes(judge(0, 0, -40.1)), ElementsAre(FindingCode::ImplausibleYaw));
  EXPECT_THAT(codes(judge(0, 0, 180)), ElementsAre(FindingCode::ImplausibleYaw));
}

TEST(LinkPlausibility, AddsThreePredictedDeviationsToTheLimit) {
  EXPECT_THAT(judge(62.9, 0, 0, 1), IsEmpty());
  EXPECT_THAT(codes(judge(63.1, 0, 0, 1)), ElementsAre(FindingCode::ImplausibleBend));
  EXPECT_THAT(judge(170, 0, 0, 40), IsEmpty()) << "nothing is known of such a link";
}

TEST(LinkPlausibility, LimitsFollowFromTheModelsElastomerAndTheLinksOwnDeviation) {
  // Six times hypot(2, 1) degrees are 13.4.
  EXPECT_THAT(judge(0, 0, 13, 1, 2), IsEmpty());
  EXPECT_THAT(codes(judge(0, 0, 14, 1, 2)), ElementsAre(FindingCode::ImplausibleYaw));
  EXPECT_THAT(codes(judge(0, 0, 20, 0, 2)), ElementsAre(FindingCode::ImplausibleYaw));
  EXPECT_THAT(judge(0, 0, 20, 5, 2), IsEmpty()) << "this link may well be turned less";
}

TEST(LinkPlausibility, SaysWhichLinkAndHowFar) {
  const std::vector<Finding> findings = judge(0, 0, 118);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].message.english(), saysAll("link 5 port 2 - 9 port 3", "118 degrees", "40"));
  EXPECT_EQ(findings[0].cells, (std::vector{CellId(5), CellId(9)}));
  EXPECT_EQ(findings[0].ports, (std::vector{PortNumber(2), PortNumber(3)}));
}

TEST(LinkPlausibility, TellsALargeYawFromALargeBend) {
  // The rotation vector of cells that are folded by 84 degrees and yawed by -141.
  const std::vector<Finding> findings = judge(44.775, -94.203, -109.067);
  EXPECT_THAT(codes(findings), ElementsAre(FindingCode::ImplausibleBend, FindingCode::ImplausibleYaw));
  EXPECT_THAT(findings[0].message.english(), HasSubstr("84 degrees"));
  EXPECT_THAT(findings[1].message.english(), HasSubstr("141 degrees"));
}

}  // namespace
}  // namespace hexoderm
