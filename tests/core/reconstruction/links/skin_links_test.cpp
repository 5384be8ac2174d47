#include "hexoderm/reconstruction/links/skin_links.h"

#include "hexoderm/graph/shortest_paths.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"

#include <algorithm>

namespace hexoderm {
namespace {

using ::testing::Each;
using ::testing::Eq;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class SkinLinksTest : public ::testing::Test {
 protected:
  SkinLinksTest() { links_.estimateEdges(); }

  PinJointedSkin skin_ = bentX17();
  std::shared_ptr<const SessionSnapshot> snapshot_ = skin_.session(orthogonalUps(3)).snapshot();
  SolverOptions options_;
  std::vector<Finding> findings_;
  SkinLinks links_{*snapshot_, options_, findings_};
};

TEST_F(SkinLinksTest, RotatesEveryLinkAsTheSkinIsBent) {
  EXPECT_THAT(findings_, IsEmpty());
  ASSERT_THAT(links_.edges(), SizeIs(16));
  for (std::size_t k = 0; k < links_.edges().size(); ++k) {
    const GraphLink& link = links_.graph().links()[k];
    const Eigen::Matrix3d truth = skin_.truth.at(links_.graph().sourceEnd(link).cell).R.transpose() *
                                  skin_.truth.at(links_.graph().targetEnd(link).cell).R;
    EXPECT_THAT(links_.edges()[k].R_c_n, RotationNear(truth, 1e-9)) << k;
    EXPECT_THAT(links_.poseResiduals(k), SizeIs(3));
  }
}

TEST_F(SkinLinksTest, EdgesFollowWhatWasDroppedOnlyWhenTheyAreEstimatedAgain) {
  const std::size_t cell = *links_.graph().indexOf(CellId(3));
  links_.dropCell(cell);
  EXPECT_TRUE(links_.readings().measured(cell));
  links_.estimateEdges();
  EXPECT_FALSE(links_.readings().measured(cell));
  EXPECT_TRUE(links_.readings().interpolated(cell));
  for (const std::size_t k : links_.graph().linksAt(cell)) {
    EXPECT_EQ(links_.edges()[k].quality, EdgeQuality::Undefined);
    EXPECT_THAT(links_.poseResiduals(k), Each(Eq(std::nullopt)));
  }
}

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

TEST_F(SkinLinksTest, WeightsAreThePapersOrGrowWithTheUncertainty) {
  EXPECT_THAT(linkWeights(links_), Each(1.0));
  options_.weights = LinkWeights::Residual;
  const std::vector<double> before = linkWeights(links_);
  const std::size_t cell = *links_.graph().indexOf(CellId(3));
  links_.dropCell(cell);
  links_.estimateEdges();
  const std::vector<double> after = linkWeights(links_);
  for (std::size_t k = 0; k < after.size(); ++k) {
    const bool is_blind = std::ranges::count(links_.graph().linksAt(cell), k) > 0;
    EXPECT_EQ(after[k] > before[k], is_blind) << k;
  }
}

}  // namespace
}  // namespace hexoderm
