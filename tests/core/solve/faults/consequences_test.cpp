#include "hexoderm/solve/faults/consequences.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/options.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using ::testing::EndsWith;

/// The link between two neighbours.
std::pair<LinkEnd, LinkEnd> linkBetween(const Session& session, CellId a, CellId b) {
  const auto report = std::ranges::find(session.neighbors(), a, &CellReport::id);
  const auto neighbor = std::ranges::find(report->neighbors, b, &NeighborReport::cell);
  return {{a, neighbor->port}, {b, neighbor->cell_port.value()}};
}

std::vector<Finding> saidOf(const Session& session, const SolverOptions& options = {}) {
  return reconstruct(*session.snapshot(), options)->findings;
}

TEST(Consequences, ARingIsSplitWithoutTwoOfItsLinksButNotWithoutOne) {
  PinJointedSkin ring = ringOfEight(45 * kDegree);
  ring.connect(kRingFirst, kRingLast);
  Session session = ring.session(orthogonalUps(3));
  session.setLinkMuted(kRingFirst, kRingLast, true);
  std::vector<Finding> findings = saidOf(session);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_THAT(findings[0].message.english(), Not(HasSubstr("split")));

  const auto [a, b] = linkBetween(session, CellId(3), CellId(4));
  session.setLinkMuted(a, b, true);
  findings = saidOf(session);
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_THAT(findings[0].message.english(), HasSubstr("split"));
  EXPECT_THAT(findings[1].message.english(), Not(HasSubstr("split"))) << "said once";
}

TEST(Consequences, NobodyCallsTheBorderOfABodyPartASplit) {
  const Session skin = bentX17().session(orthogonalUps(3));
  NeighborList neighbors = skin.neighbors();
  for (CellReport& report : neighbors) {
    const bool is_on_first_arm = report.id >= CellId(2) && report.id <= CellId(5);
    report.body_part = is_on_first_arm ? "hand" : "arm";
  }
  const std::vector<Finding> findings = saidOf(withNeighbors(skin, neighbors));
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_THAT(findings[0].message.english(), EndsWith("arm and hand; the patch ends there."));
}

TEST(Consequences, ALeafWithoutReadingsConnectsNothing) {
  const auto without = test::with(&SolverOptions::left_out, {CellId(17)});
  const std::vector<Finding> findings = saidOf(bentX17().session(orthogonalUps(3)), without);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_THAT(findings[0].message.english(), EndsWith("placed through its links."));
}

}  // namespace
}  // namespace hexoderm
