#include "hexoderm/solve/tree/skin_links.h"

#include "hexoderm/skin/shortest_paths.h"
#include "tests/support/estimated_links.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"

namespace hexoderm {
namespace {

TEST(SkinLinks, ACellBetweenTwoReadingNeighboursIsTurnedLessUncertainlyThanOneAtTheEnd) {
  test::EstimatedLinks estimated(bentX17().session(orthogonalUps(3)));
  SkinLinks& links = estimated.links;
  const std::size_t inner = *links.graph().indexOf(CellId(3));
  const std::size_t outer = *links.graph().indexOf(CellId(5));
  links.dropCell(inner);
  links.dropCell(outer);
  links.estimateEdges();
  const auto covariance = [&](std::size_t cell) {
    return links.attitudeCovariance(cell, links.graph().linksAt(cell).front());
  };
  EXPECT_NEAR(covariance(inner).trace(), covariance(outer).trace() / 2, 1e-12);
}

}  // namespace
}  // namespace hexoderm
