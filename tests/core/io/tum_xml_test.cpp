#include "hexoderm/io/tum_xml.h"

#include "hexoderm/base/file.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/base/units.h"
#include "hexoderm/skin/skin_graph.h"
#include "tests/support/matchers.h"
#include "tests/support/options.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const std::filesystem::path kTwoPatches = std::filesystem::path(HEXODERM_TEST_DATA) / "two_patches.tum.xml";

CellModel hex() { return builtInCellModel("hex-bma150"); }

/// The reader's complaint about the file with the first occurrence of one text replaced by another.
std::string complaint(const std::string& from, const std::string& to) {
  return messageOf<FormatError>([&] { parseTumXml(replaced(readFile(kTwoPatches), from, to), "t.xml"); });
}

std::vector<FindingCode> codesOf(const Reconstruction& result) { return collect(result.findings, &Finding::code); }

/// Cells of which each is placed in the frame of `root`, joined as the reports say.
TumSkinConfig::Cell cellAt(std::uint32_t id, std::uint32_t root, const SE3& T_root_u,
                           std::vector<NeighborReport> neighbors) {
  return {{CellId(id), "", std::move(neighbors)}, 0, 0, CellId(root), T_root_u};
}
std::shared_ptr<const Reconstruction> imported(const std::vector<TumSkinConfig::Cell>& cells) {
  return calibrationFromTum(test::with(&TumSkinConfig::cells, cells), hex(), "t.xml");
}
NeighborReport joined(std::uint32_t port, std::uint32_t cell) { return {PortNumber(port), CellId(cell), std::nullopt}; }

TEST(TumXml, ReadsCellsInAnyOrder) {
  const TumSkinConfig config = readTumXml(kTwoPatches);
  ASSERT_EQ(config.cells.size(), 3U);
  const TumSkinConfig::Cell& first = config.cells[0];
  EXPECT_EQ(first.patch, 1U);
  EXPECT_EQ(first.segment, 1U);
  EXPECT_EQ(first.root, CellId(2));
  EXPECT_EQ(first.report, (CellReport{CellId(4), "", {joined(3, 2), joined(4, 0)}}));
  EXPECT_NEAR(first.T_root_u.R(2, 2), std::cos(20 * kDegree), 1e-12);
  EXPECT_NEAR(first.T_root_u.t.x(), 0.023276311449, 1e-12);
  EXPECT_EQ(config.sha256, sha256Hex(readFile(kTwoPatches)));
}

TEST(TumXml, GivesItsTopologyAsASession) {
  const Session session = sessionFromTum(readTumXml(kTwoPatches), hex(), "folder/two_patches.tum.xml");
  EXPECT_EQ(session.neighbors().size(), 3U);
  EXPECT_TRUE(session.poses().empty());
  EXPECT_EQ(session.source().file, "two_patches.tum.xml");
  EXPECT_EQ(session.source().sha256, sha256Hex(readFile(kTwoPatches)));
  const SkinGraph graph(session.model(), session.neighbors());
  ASSERT_EQ(graph.links().size(), 1U);
  EXPECT_EQ(graph.sourceEnd(graph.links()[0]), (LinkEnd{CellId(2), PortNumber(2)}));
  EXPECT_EQ(graph.targetEnd(graph.links()[0]), (LinkEnd{CellId(4), PortNumber(3)}));
}

TEST(TumXml, GivesItsPlacementsAsACalibration) {
  const auto result = calibrationFromTum(readTumXml(kTwoPatches), hex(), kTwoPatches.string());
  EXPECT_EQ(result->solver, "imported");
  EXPECT_EQ(result->source.file, "two_patches.tum.xml");
  EXPECT_EQ(result->assessment.level, VerdictLevel::Usable);
  EXPECT_THAT(result->assessment.reason.english(), saysAll("Imported", "nothing was measured"));
  ASSERT_EQ(result->patches.size(), 2U);
  EXPECT_EQ(result->patches[0].origin, CellId(2));
  EXPECT_EQ(result->patches[1].origin, CellId(7));
  ASSERT_EQ(result->patches[0].links.size(), 1U);
  const LinkEstimate& link = result->patches[0].links[0];
  EXPECT_TRUE(link.used);
  EXPECT_EQ(link.quality, EdgeQuality::Undefined);
  EXPECT_TRUE(link.singular_values.isZero(0));
  EXPECT_NEAR(link.bend_rad, 20 * kDegree, 1e-9);
  EXPECT_NEAR(link.twist_rad, 0, 1e-9);
  EXPECT_NEAR(link.yaw_rad, 0, 1e-9);
  const CellPlacement* placed = result->find(CellId(4)).cell;
  ASSERT_NE(placed, nullptr);
  EXPECT_THAT(placed->T_o_u,
              SE3Near(linkTransform(link.R_c_n, hex().port(PortNumber(2)), hex().port(PortNumber(3))), 1e-9, 1e-9));
  ASSERT_EQ(placed->sensors.size(), 1U);
  EXPECT_EQ(placed->sensors[0].T_o_s.t, placed->T_o_u.t);
  EXPECT_EQ(result->layout.cells.size(), 3U);
  EXPECT_THAT(codesOf(*result), Contains(FindingCode::InterfaceLink));
  EXPECT_THAT(codesOf(*result), testing::Not(Contains(FindingCode::ImplausibleBend)));
  EXPECT_THAT(*result, IsFinite());
}

TEST(TumXml, TakesTheSmallestCellWhereTheRootLiesElsewhere) {
  // Cells 3 and 5 are placed in the frame of cell 9, which has no link to them.
  const SE3 T_9_3{expSO3({0.1, 0.2, 0.3}), {0.1, 0, 0}};
  const SE3 T_3_5 = linkTransform(expSO3({0, 0.1, 0}), hex().port(PortNumber(2)), hex().port(PortNumber(3)));
  const auto result = imported(
      {cellAt(9, 9, {}, {}), cellAt(5, 9, T_9_3 * T_3_5, {joined(3, 3)}), cellAt(3, 9, T_9_3, {joined(2, 5)})});
  ASSERT_EQ(result->patches.size(), 2U);
  EXPECT_EQ(result->patches[0].origin, CellId(3));
  EXPECT_THAT(result->find(CellId(3)).cell->T_o_u, SE3Near(SE3(), 0, 0));
  EXPECT_THAT(result->find(CellId(5)).cell->T_o_u, SE3Near(T_3_5, 1e-12, 1e-12));
}

TEST(TumXml, PlacesCellsRelativeToARootThatIsNotAtZero) {
  const SE3 T_r_1{expSO3({0, 0, 1}), {1, 2, 3}};
  const SE3 T_1_2 = linkTransform(expSO3({0, 0.1, 0}), hex().port(PortNumber(2)), hex().port(PortNumber(3)));
  const auto result = imported({cellAt(1, 1, T_r_1, {joined(2, 2)}), cellAt(2, 1, T_r_1 * T_1_2, {joined(3, 1)})});
  EXPECT_EQ(result->patches.at(0).origin, CellId(1));
  EXPECT_THAT(result->find(CellId(2)).cell->T_o_u, SE3Near(T_1_2, 1e-12, 1e-12));
}

TEST(TumXml, EndsAPatchWhereTheFrameEnds) {
  // A link between cells of two root cells says nothing about how the frames lie to each other.
  const auto result = imported({cellAt(1, 1, {}, {joined(2, 2)}), cellAt(2, 2, {}, {joined(3, 1)})});
  EXPECT_EQ(result->patches.size(), 2U);
  EXPECT_THAT(codesOf(*result), Contains(FindingCode::BodyPartBoundary));
  ASSERT_EQ(result->linkCount(), 1U);
  EXPECT_FALSE(result->patches[0].links.at(0).used);
  EXPECT_EQ(result->patches[0].links.at(0).muted_by, FindingCode::BodyPartBoundary);
}

TEST(TumXml, TurnsContradictionsIntoFindings) {
  const auto result =
      imported({cellAt(1, 1, {}, {joined(2, 2), joined(1, 1), joined(4, 99)}), cellAt(2, 1, {}, {joined(7, 1)})});
  EXPECT_THAT(codesOf(*result), testing::IsSupersetOf({FindingCode::OneSidedLink, FindingCode::SelfLink,
                                                       FindingCode::UnknownCell, FindingCode::UnknownPort}));
  EXPECT_EQ(result->cellCount(), 2U);
}

TEST(TumXml, TakesASkinWithoutCells) {
  const TumSkinConfig config = parseTumXml("<SkinConfig numberOfCells=\"0\"/>", "t.xml");
  EXPECT_TRUE(config.cells.empty());
  EXPECT_EQ(calibrationFromTum(config, hex(), "t.xml")->cellCount(), 0U);
}

TEST(TumXml, NamesTheCellAndElementThatIsWrong) {
  EXPECT_THAT(complaint("rows=\"3\" cols=\"1\"", "rows=\"4\" cols=\"1\""),
              saysAll("t.xml: line", "cell 4, pos", "3 x 1, found 4 x 1"));
  EXPECT_THAT(complaint("rows=\"3\" cols=\"3\"", "rows=\"3\" cols=\"1\""),
              saysAll("cell 4, rot", "3 x 3, found 3 x 1"));
  EXPECT_THAT(complaint("<element row=\"1\" col=\"0\">", "<element row=\"0\" col=\"0\">"),
              saysAll("cell 4, pos", "row 0 col 0", "once"));
  EXPECT_THAT(complaint("<element row=\"2\" col=\"0\">", "<element row=\"3\" col=\"0\">"),
              saysAll("cell 4, pos", "row 3 col 0", "outside"));
  EXPECT_THAT(complaint("<element row=\"2\" col=\"0\">", "<element col=\"0\">"),
              saysAll("cell 4, pos", "attribute row"));
  EXPECT_THAT(complaint("<pos>", "<position>") + complaint("<rootCellId>2</rootCellId>", ""),
              saysAll("not well-formed", "cell 4", "<rootCellId>, but there is none"));
  EXPECT_THAT(complaint("<rootCellId>2</rootCellId>", "<rootCellId>two</rootCellId>"),
              saysAll("line 5", "cell 4", "rootCellId", "\"two\""));
  EXPECT_THAT(complaint("<rootCellId>2</rootCellId>", "<rootCellId>2</rootCellId><rootCellId>2</rootCellId>"),
              saysAll("cell 4", "only one <rootCellId>"));
  EXPECT_THAT(complaint("<neighbor port=\"4\"", "<neighbor port=\"3\""),
              saysAll("cell 4, neighbor at port 3", "each port once"));
  EXPECT_THAT(complaint("size=\"2\"", "size=\"3\""), saysAll("cell 4, neighbors", "size=\"3\"", "found 2"));
  EXPECT_THAT(complaint("<neighbors id=\"4\"", "<neighbors id=\"5\""), saysAll("cell 4, neighbors", "found 5"));
  EXPECT_THAT(complaint("<cell id=\"2\"", "<cell id=\"-2\""), saysAll("cell", "id", "\"-2\""));
  EXPECT_THAT(complaint("<cell id=\"2\"", "<cell id=\"4294967296\""), saysAll("cell", "id", "\"4294967296\""));
  EXPECT_THAT(complaint("patch=\"1\" ", ""), saysAll("cell 4", "attribute patch"));
  EXPECT_THAT(complaint("numberOfCells=\"3\"", "numberOfCells=\"4\""), saysAll("numberOfCells=\"4\"", "found 3"));
  EXPECT_THAT(complaint("numberOfCells=\"3\"", ""), saysAll("attribute numberOfCells"));
}

TEST(TumXml, RefusesACellThatIsThereTwice) {
  std::string text = readFile(kTwoPatches);
  const std::size_t begin = text.find("    <cell id=\"7\"");
  text.insert(begin, text.substr(begin, text.find("</SkinConfig>") - begin));
  EXPECT_THAT(messageOf<FormatError>([&] { parseTumXml(text, "t.xml"); }), saysAll("cell 7", "each cell once"));
}

TEST(TumXml, RefusesNumbersThatAreNone) {
  for (const char* number : {"nan", "inf", "1e999", "", "0,5", "0.5 0.5", "0x1"}) {
    EXPECT_THAT(complaint("0.023276311449", number), saysAll("t.xml", "cell 4, pos", "row 0 col 0", "number"))
        << number;
  }
}

TEST(TumXml, RefusesPositionsFromWhichNothingFiniteFollows) {
  for (const char* far : {"1e308", "-1000.1"}) {
    EXPECT_THAT(complaint("0.023276311449", far), saysAll("t.xml: line ", "cell 4, pos", "metres", "at most 1000"));
  }
}

TEST(TumXml, RefusesWhatIsNoRotation) {
  EXPECT_THAT(complaint("0.939692620786", "0.95"), saysAll("cell 4, rot", "rotation matrix"));
  std::string text = readFile(kTwoPatches);
  const std::size_t at = text.rfind("1.000000000000");
  text.insert(at, "-");  // a mirror
  EXPECT_THAT(messageOf<FormatError>([&] { parseTumXml(text, "t.xml"); }), saysAll("cell 7, rot", "determinant +1"));
}

TEST(TumXml, RefusesOtherDocuments) {
  EXPECT_THAT(messageOf<FormatError>([] { parseTumXml("<robot name=\"x\"/>", "t.xml"); }),
              saysAll("t.xml", "SkinConfig", "found robot"));
  EXPECT_THAT(messageOf<FormatError>([] { parseTumXml("", "t.xml"); }), saysAll("t.xml", "not well-formed"));
  EXPECT_THAT(messageOf<FormatError>([] { parseTumXml("{}", "t.xml"); }), saysAll("t.xml"));
}

TEST(TumXml, IsRefusedWhereverItIsCutOff) {
  const std::string text = readFile(kTwoPatches);
  expectRefusedWhereverCutOff(text, text.find_last_of('>'),
                              "t.xml: ", [](const std::string& cut) { parseTumXml(cut, "t.xml"); });
}

}  // namespace
}  // namespace hexoderm
