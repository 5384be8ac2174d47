// SDF and MJCF: what they hold, and that a changed file is noticed. What Gazebo's and MuJoCo's own libraries read is in
// sdformat_reader_test.cpp and mujoco_reader_test.cpp.

#include "hexoderm/io/export_models.h"

#include "hexoderm/util/error.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using ::testing::HasSubstr;
using ExportModels = ExportTest;

SkinTree treeOf(const Reconstruction& reconstruction, const ExportOptions& options) {
  const ExportSelection selection =
      selectForExport(reconstruction, exportFormatDescription(ExportFormat::Sdf), options);
  return skinTree(*reconstruction.model, selection.mounted, reconstruction, options);
}

TEST_F(ExportModels, HoldOneLinkOfTheRobot) {
  ExportOptions options;
  options.placements = {{CellId(7), "forearm", {}, {}}, {CellId(20), "hand", {}, {}}};
  for (const ExportFormat format : {ExportFormat::Sdf, ExportFormat::Mjcf}) {
    EXPECT_THAT(messageOf<InvalidArgument>([&] { exportBytes(makeTestReconstruction(), format, options, "f"); }),
                HasSubstr("placed on 2 links"));
  }
}

TEST_F(ExportModels, ATamperedFileIsDetected) {
  const SkinTree tree = treeOf(makeTestReconstruction(), {});
  const std::string sdf = sdfBytes(tree);
  EXPECT_NO_THROW(verifySdf(sdf, tree, "f"));
  for (const std::string& bytes : {replaced(sdf, "-0.024 0.0013", "-0.025 0.0013"),
                                   replaced(sdf, "frame name=\"skin_cell12\"", "frame name=\"x\""),
                                   replaced(sdf, "attached_to=\"skin_patch0\"", "attached_to=\"base_link\""),
                                   replaced(sdf, "0.01502", "0.01503"), sdf.substr(0, sdf.size() / 2)}) {
    EXPECT_THROW(verifySdf(bytes, tree, "f"), FormatError) << bytes;
  }
  const std::string mjcf = mjcfBytes(tree);
  EXPECT_NO_THROW(verifyMjcf(mjcf, tree, "f"));
  for (const std::string& bytes : {replaced(mjcf, "-0.024 0.0013", "-0.025 0.0013"),
                                   replaced(mjcf, "body name=\"skin_cell12\"", "body name=\"x\""),
                                   replaced(mjcf, "site name=\"skin_cell3_acc", "site name=\"skin_cell3_a"),
                                   replaced(mjcf, "0.01502", "0.01503"), mjcf.substr(0, mjcf.size() / 2)}) {
    EXPECT_THROW(verifyMjcf(bytes, tree, "f"), FormatError) << bytes;
  }
}

}  // namespace
}  // namespace hexoderm
