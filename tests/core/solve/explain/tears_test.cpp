#include "hexoderm/solve/faults/tears.h"
#include "hexoderm/solve/metrics/assess.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/estimated_links.h"
#include "tests/support/matchers.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

#include <set>
#include <utility>

namespace hexoderm {
namespace {

std::vector<Finding> aboveInfo(const Reconstruction& result) {
  std::vector<Finding> findings;
  for (const Finding& finding : result.findings) {
    if (finding.severity != Severity::Info) findings.push_back(finding);
  }
  return findings;
}

/// The cells behind the line through a cable, which are moved in truth, and the others.
std::set<CellId> farSide(SimulatedSkinOptions options) {
  options.link_faults.front().kind = LinkFaultKind::Cable;
  const SimulatedSkin torn = test::simulatedSkin(options);
  options.link_faults.clear();
  const SimulatedSkin whole = test::simulatedSkin(options);
  std::set<CellId> far;
  for (const TrueCell& cell : torn.truth()) {
    const CellId id = cell.id;
    if (!cell.T_b_u.t.isApprox(test::truePlacement(whole, id).t, 1e-9)) far.insert(id);
  }
  return far;
}

TEST(TornSkin, IsOneFindingThatNamesTheLinksAcrossTheTearAndNoOthers) {
  for (const LinkFaultKind kind : {LinkFaultKind::Cable, LinkFaultKind::Joint}) {
    SimulatedSkinOptions options = test::skinOptions("sheet:12x13", "cylinder:r=0.1", 2);
    options.link_faults = {{kind, {CellId(80), PortNumber(1)}}};
    const auto result = reconstruct(*test::simulatedSession(options, 4).snapshot());
    const std::vector<Finding> findings = aboveInfo(*result);
    ASSERT_THAT(findings, ElementsAre(Field(&Finding::code, FindingCode::TornSkin)));
    const std::set<CellId> far = farSide(options);
    const Finding& tear = findings.front();
    ASSERT_EQ(tear.cells.size(), tear.ports.size());
    EXPECT_GE(result->patches.size(), 2U);
    for (std::size_t k = 0; k < tear.cells.size(); k += 2) {
      EXPECT_NE(far.contains(tear.cells[k]), far.contains(tear.cells[k + 1]));
      const LinkEstimate* link =
          result->findLink({tear.cells[k], tear.ports[k]}, {tear.cells[k + 1], tear.ports[k + 1]});
      ASSERT_NE(link, nullptr);
      EXPECT_EQ(link->muted_by, FindingCode::TornSkin);
    }
  }
}

TEST(TornSkin, IsNotSaidOfOneBadLinkBesideSoundOnes) {
  SimulatedSkinOptions options = test::skinOptions("sheet:5x5", "cylinder:r=0.08", 2);
  const Session whole = test::simulatedSession(options, 4);
  test::EstimatedLinks skin(whole);
  std::vector<double> deviations = linkDeviations(skin.links);
  for (std::size_t link = 0; link < deviations.size(); ++link) {
    const double before = std::exchange(deviations[link], 20.0);
    EXPECT_THAT(tearThrough(skin.links, link, deviations), IsEmpty()) << link;
    deviations[link] = before;
  }
}

TEST(TornSkin, IsNotSaidOfOneCableInAChain) {
  SimulatedSkinOptions options = test::skinOptions("ring8", "", 2);
  options.link_faults = {{LinkFaultKind::Joint, {CellId(4), PortNumber(2)}}};
  const auto result = reconstruct(*test::simulatedSession(options, 4).snapshot());
  EXPECT_THAT(aboveInfo(*result), ElementsAre(Field(&Finding::code, FindingCode::LinkNotRigid)));
}

TEST(DirectionsAlongOneLine, AccuseNobodyAndAreSaidToBeTooFew) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    SimulatedSkin skin = test::simulatedSkin(test::skinOptions("sheet:5x5", "cylinder:r=0.08", seed));
    Session session = beginSimulatedSession(skin);
    const Eigen::Vector3d up = Eigen::Vector3d(0.4, -0.9, 0.1).normalized();
    for (const double sign : {1.0, -1.0, 1.0, -1.0}) {
      const PoseId id = session.nextPoseId();
      session.addPose(
          {std::make_shared<const PoseCapture>(averageFrames(skin.record(sign * up, 100), id, message("pose {}", id))),
           false});
    }
    const auto result = reconstruct(*session.snapshot());
    EXPECT_THAT(aboveInfo(*result), ElementsAre(Field(&Finding::code, FindingCode::TooFewDirections))) << seed;
    EXPECT_EQ(result->assessment.level, VerdictLevel::NotEnough);
  }
}

}  // namespace
}  // namespace hexoderm
