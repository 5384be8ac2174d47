#include "hexoderm/reconstruction/faults/fault_isolation.h"

#include "hexoderm/util/error.h"
#include "tests/support/changed_session.h"
#include "tests/support/error_matchers.h"
#include "tests/support/pin_jointed_skin.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;

class FaultIsolation : public ::testing::Test {
 protected:
  SkinLinks& links(const Session& session) {
    snapshot_ = session.snapshot();
    links_ = std::make_unique<SkinLinks>(*snapshot_, options_, findings_);
    return *links_;
  }

  PinJointedSkin skin_ = bentX17();
  SolverOptions options_;
  std::vector<Finding> findings_;

 private:
  std::shared_ptr<const SessionSnapshot> snapshot_;
  std::unique_ptr<SkinLinks> links_;
};

TEST_F(FaultIsolation, ASoundSkinStaysAsItIs) {
  SkinLinks& links = this->links(skin_.session(orthogonalUps(4)));
  links.estimateEdges();
  EXPECT_EQ(isolateSuspects(links, {}, findings_), Completion::Finished);
  EXPECT_THAT(findings_, IsEmpty());
  for (const GraphLink& link : links.graph().links()) EXPECT_FALSE(link.muted());
}

TEST_F(FaultIsolation, ACellThatContradictsItsNeighboursIsDroppedInsteadOfItsLinks) {
  const Session session = changed(skin_.session(orthogonalUps(4)), [](std::size_t, GravitySample& sample) {
    if (sample.cell == CellId(3)) sample.mean_g = Eigen::Vector3d(sample.mean_g.y(), sample.mean_g.x(), 0.9);
  });
  SkinLinks& links = this->links(session);
  links.estimateEdges();
  EXPECT_EQ(isolateSuspects(links, {}, findings_), Completion::Finished);
  EXPECT_THAT(findings_, ElementsAre(Field(&Finding::cells, ElementsAre(CellId(3)))));
  EXPECT_FALSE(links.readings().measured(*links.graph().indexOf(CellId(3))));
  for (const GraphLink& link : links.graph().links()) EXPECT_FALSE(link.muted());
}

TEST_F(FaultIsolation, LeavesAtOnceWhenItIsStopped) {
  SkinLinks& links = this->links(skin_.session(orthogonalUps(4)));
  links.estimateEdges();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(isolateSuspects(links, stop.get_token(), findings_), Completion::Stopped);
}

TEST_F(FaultIsolation, LeavingOutDropsTheReadingsOfACell) {
  options_.left_out = {CellId(4)};
  SkinLinks& links = this->links(skin_.session(orthogonalUps(2)));
  leaveOutCells(links, findings_);
  links.estimateEdges();
  EXPECT_FALSE(links.readings().measured(*links.graph().indexOf(CellId(4))));
  EXPECT_THAT(findings_, ElementsAre(Field(&Finding::code, FindingCode::LeftOut)));
  options_.left_out = {CellId(99)};
  EXPECT_THAT(test::messageOf<InvalidArgument>([&] { leaveOutCells(links, findings_); }), ::testing::HasSubstr("99"));
}

TEST_F(FaultIsolation, LinksSetAsideAreMutedAndThePatchEndsThere) {
  Session session = skin_.session(orthogonalUps(2));
  const SkinGraph graph(session.model(), session.neighbors());
  const GraphLink& link = graph.links().front();
  session.setLinkMuted(graph.sourceEnd(link), graph.targetEnd(link), true, "a cable");
  SkinLinks& links = this->links(session);
  ASSERT_EQ(links.graph().patches().size(), 1U);
  setLinksAside(links, findings_);
  EXPECT_EQ(links.graph().links().front().muted_by, FindingCode::LinkSetAside);
  EXPECT_EQ(links.graph().patches().size(), 2U);
  EXPECT_THAT(findings_, ElementsAre(Field(&Finding::code, FindingCode::LinkSetAside)));
}

}  // namespace
}  // namespace hexoderm
