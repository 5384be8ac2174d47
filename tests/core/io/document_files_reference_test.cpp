// Sessions of real skins and the real TUM file; registered only where they are.

#include "hexoderm/base/file.h"
#include "hexoderm/base/units.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/io/tum_xml.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/matchers.h"
#include "tests/support/paths.h"
#include "tests/support/session_matchers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const std::filesystem::path kReference = HEXODERM_REFERENCE_DATA;

std::shared_ptr<const Reconstruction> realSkin() {
  const std::filesystem::path path = kReference / "real" / "tum_skin_config.xml";
  return calibrationFromTum(readTumXml(path), builtInCellModel("hex-bma150"), path.string());
}

std::vector<FindingCode> findingsAt(const Reconstruction& result, std::uint32_t a, std::uint32_t b) {
  std::vector<FindingCode> codes;
  for (const Finding& finding : result.findings) {
    if (finding.cells == std::vector{CellId(a), CellId(b)}) codes.push_back(finding.code);
  }
  return codes;
}

TEST(RealSessions, ComeBackAsTheyWere) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kReference / "real")) {
    if (!entry.path().string().ends_with(".session.json")) continue;
    SCOPED_TRACE(entry.path().string());
    const Session session = readSessionJson(entry.path());
    test::expectSameSession(parseSessionJson(sessionToJson(session), "s.json"), session);
    const auto result = reconstruct(*session.snapshot());
    EXPECT_EQ(parseCalibrationJson(calibrationToJson(*result), "c.json")->findings, result->findings);
    ++count;
  }
  EXPECT_GE(count, 7U);
}

TEST(RealTumFile, ObeysEquationThreeWithTheBuiltInModel) {
  const auto result = realSkin();
  ASSERT_EQ(result->patches.size(), 1U);
  const PatchReconstruction& patch = result->patches[0];
  EXPECT_EQ(patch.origin, CellId(1));
  ASSERT_EQ(patch.cells.size(), 4U);
  ASSERT_EQ(patch.links.size(), 3U);
  for (const LinkEstimate& link : patch.links) {
    const SE3 T_c_n = patch.findCell(link.source.cell)->T_o_u.inverse() * patch.findCell(link.target.cell)->T_o_u;
    EXPECT_THAT(T_c_n, SE3Near(linkTransform(link.R_c_n, result->model->port(link.source.port),
                                             result->model->port(link.target.port)),
                               1e-9, 1e-6));
  }
  EXPECT_THAT(*result, IsFinite());
}

TEST(RealTumFile, JoinsThePortsThatBothSidesName) {
  const auto result = realSkin();
  EXPECT_NE(result->findLink({CellId(1), PortNumber(3)}, {CellId(2), PortNumber(3)}), nullptr);
  EXPECT_NE(result->findLink({CellId(2), PortNumber(4)}, {CellId(3), PortNumber(4)}), nullptr);
  EXPECT_NE(result->findLink({CellId(3), PortNumber(3)}, {CellId(4), PortNumber(3)}), nullptr);
}

TEST(RealTumFile, NamesTheLinksThatNoSkinHas) {
  const auto result = realSkin();
  EXPECT_THAT(findingsAt(*result, 1, 2),
              ::testing::ElementsAre(FindingCode::ImplausibleBend, FindingCode::ImplausibleYaw));
  EXPECT_THAT(findingsAt(*result, 2, 3), ::testing::ElementsAre(FindingCode::ImplausibleBend));
  EXPECT_THAT(findingsAt(*result, 3, 4), ::testing::IsEmpty());
}

TEST(RealTumFile, SurvivesTheWayThroughACalibration) {
  const auto result = realSkin();
  const auto back = parseCalibrationJson(calibrationToJson(*result), "c.json");
  EXPECT_EQ(back->solver, "imported");
  EXPECT_EQ(back->findings, result->findings);
  for (const CellPlacement& cell : result->patches[0].cells) {
    EXPECT_EQ(back->find(cell.cell).cell->T_o_u.R, cell.T_o_u.R);
    EXPECT_EQ(back->find(cell.cell).cell->T_o_u.t, cell.T_o_u.t);
  }
}

}  // namespace
}  // namespace hexoderm
