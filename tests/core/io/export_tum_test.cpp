#include "hexoderm/io/exporter.h"
#include "hexoderm/io/tum_xml.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

#include <pugixml.hpp>

namespace hexoderm {
namespace {

TEST(ExportTum, HoldsEveryPatchInTheFrameOfItsRootCell) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const TumSkinConfig config = parseTumXml(exportBytes(reconstruction, ExportFormat::Tum, {}), "skin.xml");
  ASSERT_EQ(config.cells.size(), 4U);
  const TumSkinConfig::Cell& third = config.cells[2];
  EXPECT_EQ(third.report.id, CellId(12));
  EXPECT_EQ(third.root, CellId(7));
  EXPECT_EQ(third.patch, 1U);
  EXPECT_LT((third.T_root_u.t - reconstruction.patches[0].cells[2].T_o_u.t).norm(), 1e-11);
  EXPECT_LT((third.T_root_u.R - reconstruction.patches[0].cells[2].T_o_u.R).norm(), 1e-9);
  EXPECT_EQ(config.cells[3].root, CellId(20));
  EXPECT_EQ(config.cells[3].patch, 2U);
  EXPECT_THAT(collect(config.cells[1].report.neighbors, &NeighborReport::cell),
              ElementsAre(CellId(12), CellId(12), CellId(3), CellId(20)))
      << "cell 7, the links that are not used too";
}

TEST(ExportTum, SaysWhereEveryRootCellIsInItsLink) {
  const SE3 T_hand_20{rotationFromRpy({0.4, -0.9, 2.5}), {0.25, 0, -0.125}};
  const ExportOptions options = test::with(&ExportOptions::placements, {{CellId(20), "hand", T_hand_20, {}}});
  const std::string text = exportBytes(makeTestReconstruction(), ExportFormat::Tum, options);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_buffer(text.data(), text.size()));
  const auto expectAt = [&](const char* patch, const std::string& frame, const SE3& T) {
    const pugi::xml_node extrinsics =
        document.child("SkinConfig").find_child_by_attribute("patchExtrinsics", "patchId", patch);
    EXPECT_EQ(extrinsics.attribute("baseFrame").value(), frame);
    const pugi::xml_node place = extrinsics.child("tf_rootCell_base");
    SE3 found;
    for (const pugi::xml_node element : place.child("pos").child("matrix").children("element")) {
      found.t[element.attribute("row").as_int()] = element.text().as_double();
    }
    for (const pugi::xml_node element : place.child("rot").child("matrix").children("element")) {
      found.R(element.attribute("row").as_int(), element.attribute("col").as_int()) = element.text().as_double();
    }
    EXPECT_LT((found.t - T.t).norm(), 1e-11) << patch;
    EXPECT_LT((found.R - T.R).norm(), 1e-11) << patch;
  };
  expectAt("1", "base_link", {});
  expectAt("2", "hand", T_hand_20);
}

}  // namespace
}  // namespace hexoderm
