#include "hexoderm/solve/tree/skin_links.h"

#include "hexoderm/skin/shortest_paths.h"
#include "tests/support/estimated_links.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"

namespace hexoderm {
namespace {

class SkinLinksTest : public ::testing::Test {
 protected:
  test::EstimatedLinks estimated_{bentX17().session(orthogonalUps(3))};
  SkinLinks& links_ = estimated_.links;
};

TEST_F(SkinLinksTest, ADroppedPoseIsUsedByNoLink) {
  links_.dropPose(1);
  links_.estimateEdges();
  ASSERT_FALSE(links_.graph().links().empty());
  for (const GraphLink& link : links_.graph().links()) {
    EXPECT_THAT(links_.readings().posesOf(link), ::testing::ElementsAre(0, 2));
  }
}

TEST_F(SkinLinksTest, ACellBetweenTwoReadingNeighboursIsTurnedLessUncertainlyThanOneAtTheEnd) {
  const std::size_t inner = *links_.graph().indexOf(CellId(3));
  const std::size_t outer = *links_.graph().indexOf(CellId(5));
  links_.dropCell(inner);
  links_.dropCell(outer);
  links_.estimateEdges();
  const auto covariance = [&](std::size_t cell) {
    return links_.attitudeCovariance(cell, links_.graph().linksAt(cell).front());
  };
  EXPECT_NEAR(covariance(inner).trace(), covariance(outer).trace() / 2, 1e-12);
}

}  // namespace
}  // namespace hexoderm
