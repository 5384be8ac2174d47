#include "hexoderm/io/export_tum.h"

#include "hexoderm/io/tum_xml.h"
#include "hexoderm/util/error.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using ::testing::ElementsAre;

TEST(ExportTum, HoldsEveryPatchInTheFrameOfItsRootCell) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const TumSkinConfig config = parseTumXml(exportBytes(reconstruction, ExportFormat::Tum, {}, "skin.xml"), "skin.xml");
  ASSERT_EQ(config.cells.size(), 4U);
  const TumSkinConfig::Cell& third = config.cells[2];
  EXPECT_EQ(third.report.id, CellId(12));
  EXPECT_EQ(third.root, CellId(7));
  EXPECT_EQ(third.patch, 1U);
  EXPECT_LT((third.T_root_u.t - reconstruction.patches[0].cells[2].T_o_u.t).norm(), 1e-11);
  EXPECT_LT((third.T_root_u.R - reconstruction.patches[0].cells[2].T_o_u.R).norm(), 1e-9);
  EXPECT_EQ(config.cells[3].root, CellId(20));
  EXPECT_EQ(config.cells[3].patch, 2U);
  std::vector<std::uint32_t> neighbors;
  for (const NeighborReport& neighbor : config.cells[1].report.neighbors) neighbors.push_back(neighbor.cell.value());
  EXPECT_THAT(neighbors, ElementsAre(12, 12, 3, 20)) << "cell 7, the links that are not used too";
}

TEST(ExportTum, ATamperedFileIsDetected) {
  const Reconstruction reconstruction = makeTestReconstruction();
  ExportOptions options;
  options.placements = {{CellId(20), "hand", {Eigen::Matrix3d::Identity(), {0.25, 0, 0}}, {}}};
  const std::string text = tumBytes(reconstruction, options);
  EXPECT_NO_THROW(verifyTum(text, reconstruction, options, "f"));
  for (const std::string& bytes :
       {replaced(text, "-0.024000000000", "-0.024000001000"), replaced(text, "baseFrame=\"hand\"", "baseFrame=\"arm\""),
        replaced(text, "0.250000000000", "0.250000001000"), replaced(text, "patch=\"2\"", "patch=\"1\""),
        replaced(text, "port=\"4\" id=\"20\"", "port=\"4\" id=\"0\""), text.substr(0, text.size() / 2)}) {
    EXPECT_THROW(verifyTum(bytes, reconstruction, options, "f"), FormatError) << bytes;
  }
}

}  // namespace
}  // namespace hexoderm
