// The reference sessions and the real TUM file; registered only where they are.

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/io/tum_xml.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/units.h"
#include "tests/support/both_readers.h"
#include "tests/support/matchers.h"

#include <gtest/gtest.h>

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

TEST(ReferenceSessions, AreReadAndComeBackAsTheyWere) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kReference / "vectors")) {
    SCOPED_TRACE(entry.path().filename().string());
    const Session session = readSessionJson(entry.path());
    EXPECT_EQ(session.model().name, "reference-hex");
    ASSERT_NE(session.truth(), nullptr);
    EXPECT_EQ(session.truth()->cells.size(), session.neighbors().size());
    EXPECT_FALSE(session.poses().empty());
    const std::string text = sessionToJson(session);
    const Session back = parseSessionJson(text, "back.json");
    EXPECT_EQ(sessionToJson(back), text);
    EXPECT_EQ(back.neighbors(), session.neighbors());
    for (std::size_t p = 0; p < session.poses().size(); ++p) {
      const auto& samples = session.poses()[p].capture->samples;
      const auto& samples_back = back.poses()[p].capture->samples;
      ASSERT_EQ(samples.size(), samples_back.size());
      for (std::size_t k = 0; k < samples.size(); ++k) {
        EXPECT_EQ(samples[k].mean_g, samples_back[k].mean_g);
        EXPECT_EQ(samples[k].cov_g2, samples_back[k].cov_g2);
        EXPECT_EQ(samples[k].count, samples_back[k].count);
      }
    }
    ++count;
  }
  EXPECT_GE(count, 5U);
}

TEST(ReferenceSessions, AreTheSameForBothReaders) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kReference)) {
    if (!entry.path().string().ends_with(".session.json")) continue;
    SCOPED_TRACE(entry.path().string());
    const std::string text = readFile(entry.path());
    EXPECT_EQ(test::readSessionBothWays(text), test::TakenBy::Both);
    const auto result = reconstruct(*parseSessionJson(text, "s.json").snapshot());
    EXPECT_EQ(test::readCalibrationBothWays(calibrationToJson(*result)), test::TakenBy::Both);
    ++count;
  }
  EXPECT_GE(count, 12U);
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
