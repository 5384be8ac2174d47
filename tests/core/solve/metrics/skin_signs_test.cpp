#include "hexoderm/solve/metrics/skin_signs.h"

#include "hexoderm/solve/metrics/cell_metrics.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

Finding about(FindingCode code, std::vector<CellId> cells, std::vector<PortNumber> ports = {}) {
  return makeFinding(code, Message::verbatim("made for a test"), std::move(cells), std::move(ports));
}

TEST(SkinSigns, ASkinWithoutFaultsHasNone) {
  const SkinSigns signs = signsOf(demoReconstruction());
  EXPECT_EQ(signs.cells.size(), 17U);
  EXPECT_THAT(signs.cells, Each(CellSign{}));
  EXPECT_THAT(signs.links, IsEmpty());
}

TEST(SkinSigns, FindingsAboutReadingsAreSignsOfTheirCells) {
  Reconstruction demo = demoReconstruction();
  demo.patches[0].cells[4].placed_by = PlacedBy::Links;
  demo.patches[0].cells[6].placed_by = PlacedBy::Links;
  demo.findings = {about(FindingCode::TurnedSensor, {CellId(5)}), about(FindingCode::NoisySensor, {CellId(5)}),
                   about(FindingCode::NoisySensor, {CellId(2)}), about(FindingCode::LeftOut, {CellId(7)}),
                   about(FindingCode::DeadSensor, {CellId(999)})};
  const SkinSigns signs = signsOf(demo);
  const CellMetrics figures = makeCellMetrics(demo);
  for (std::size_t k = 0; k < figures.cells.size(); ++k) {
    const std::uint32_t cell = figures.cells[k].value();
    EXPECT_EQ(signs.cells[k].faulty, cell == 5) << cell;
    EXPECT_EQ(signs.cells[k].doubtful, cell == 2) << cell << ": an error is said before a warning";
    EXPECT_EQ(signs.cells[k].by_links, cell == 5 || cell == 7) << cell;
  }
}

TEST(SkinSigns, WhereNothingWasMeasuredNoCellIsToldApart) {
  Reconstruction demo = demoReconstruction();
  for (CellPlacement& cell : demo.patches[0].cells) cell.placed_by = PlacedBy::Links;
  EXPECT_THAT(signsOf(demo).cells, Each(CellSign{}));
}

TEST(SkinSigns, FindingsAboutLinksAreSignsOfTheLinks) {
  Reconstruction demo = demoReconstruction();
  const LinkEstimate& link = demo.patches[0].links[3];
  const auto between = [&](FindingCode code) {  // named from its other end
    return about(code, {link.target.cell, link.source.cell}, {link.target.port, link.source.port});
  };
  demo.findings = {between(FindingCode::ImplausibleBend), between(FindingCode::LinkNotRigid)};
  const SkinSigns signs = signsOf(demo);
  EXPECT_THAT(signs.links, ElementsAre(std::pair(link.source, link.target)));
  EXPECT_THAT(signs.cells, Each(CellSign{}));
  demo.findings = {between(FindingCode::LinkSetAside)};
  EXPECT_THAT(signsOf(demo).links, IsEmpty()) << "the operator knows";
  demo.findings = {about(FindingCode::ImplausibleBend, {CellId(1), CellId(1)}, {PortNumber(1), PortNumber(2)})};
  EXPECT_THAT(signsOf(demo).links, IsEmpty()) << "there is no such link";
}

TEST(SkinSigns, ATearIsASignOfAllLinksThatItNames) {
  Reconstruction demo = demoReconstruction();
  const LinkEstimate& a = demo.patches[0].links[3];
  const LinkEstimate& b = demo.patches[0].links[7];
  demo.findings = {about(FindingCode::TornSkin, {a.source.cell, a.target.cell, b.source.cell, b.target.cell},
                         {a.source.port, a.target.port, b.source.port, b.target.port})};
  EXPECT_THAT(signsOf(demo).links,
              testing::UnorderedElementsAre(std::pair(a.source, a.target), std::pair(b.source, b.target)));
}

TEST(SkinSigns, OneQualityIsThatOfAllUsedLinks) {
  Reconstruction demo = demoReconstruction();
  EXPECT_TRUE(isOfOneQuality(demo));
  demo.patches[0].links[2].quality = EdgeQuality::Over;
  EXPECT_FALSE(isOfOneQuality(demo));
  demo.patches[0].links[2].used = false;
  EXPECT_TRUE(isOfOneQuality(demo));
  for (LinkEstimate& link : demo.patches[0].links) link.quality = EdgeQuality::Undefined;
  EXPECT_FALSE(isOfOneQuality(demo)) << "nothing is known, which has to be seen";
  demo.patches[0].links.clear();
  EXPECT_FALSE(isOfOneQuality(demo));
}

}  // namespace
}  // namespace hexoderm
