#include "hexoderm/solve/metrics/cell_links.h"

#include "tests/support/hand_made_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using ::testing::ElementsAreArray;

std::vector<CellId> neighborsIn(LinksOfCell links, CellId cell) {
  std::vector<CellId> cells;
  for (const LinkEstimate* link : links) cells.push_back(neighborAcross(*link, cell));
  return cells;
}

TEST(CellLinks, LeadFromACellToItsNeighboursInTheOrderOfItsPorts) {
  const Reconstruction demo = demoReconstruction();
  const CellLinks links(demo);
  EXPECT_THAT(neighborsIn(links.of(0), CellId(1)), ElementsAre(CellId(2), CellId(3), CellId(4), CellId(5)));
  // Cell 6 is the second of the arm of cell 2, and its port 4 leads back.
  EXPECT_THAT(neighborsIn(links.of(5), CellId(6)), ElementsAre(CellId(10), CellId(2)));
  EXPECT_EQ(portOf(*links.of(5)[1], CellId(6)), PortNumber(4));
  EXPECT_THAT(neighborsIn(links.of(16), CellId(17)), ElementsAre(CellId(13)));
  EXPECT_THAT(links.of(17), IsEmpty());
  EXPECT_THAT(CellLinks().of(0), IsEmpty());
}

TEST(CellLinks, AreTheSameForOneCellAsForAll) {
  const Reconstruction sheet = cylinderSheet(8, 6);
  const CellLinks links(sheet);
  std::size_t index = 0;
  std::size_t ends = 0;
  for (const PatchReconstruction& patch : sheet.patches) {
    for (const CellPlacement& cell : patch.cells) {
      EXPECT_THAT(links.of(index), ElementsAreArray(linksOf(sheet, cell.cell))) << cell.cell;
      ends += links.of(index++).size();
    }
  }
  EXPECT_EQ(ends, 2 * sheet.linkCount());
}

TEST(CellLinks, HoldALinkIntoAnotherPatchAtBothOfItsCells) {
  Reconstruction two = demoPatches({DemoOptions(), {.first_id = 101}});
  LinkEstimate across = test::usedLink();
  across.source = {CellId(14), PortNumber(1)};
  across.target = {CellId(101), PortNumber(4)};
  across.used = false;
  two.patches[0].links.push_back(across);
  const CellLinks links(two);
  EXPECT_THAT(neighborsIn(links.of(13), CellId(14)), testing::Contains(CellId(101)));
  EXPECT_THAT(neighborsIn(links.of(17), CellId(101)), testing::Contains(CellId(14)));
}

}  // namespace
}  // namespace hexoderm
