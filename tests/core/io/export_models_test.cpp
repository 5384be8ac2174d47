// SDF and MJCF: what they refuse. What Gazebo's and MuJoCo's own libraries read is in sdformat_reader_test.cpp and
// mujoco_reader_test.cpp.

#include "hexoderm/io/exporter.h"
#include "hexoderm/util/error.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using ::testing::HasSubstr;
using ExportModels = ExportTest;

TEST_F(ExportModels, HoldOneLinkOfTheRobot) {
  ExportOptions options;
  options.placements = {{CellId(7), "forearm", {}, {}}, {CellId(20), "hand", {}, {}}};
  for (const ExportFormat format : {ExportFormat::Sdf, ExportFormat::Mjcf}) {
    EXPECT_THAT(messageOf<InvalidArgument>([&] { exportBytes(makeTestReconstruction(), format, options, "f"); }),
                HasSubstr("placed on 2 links"));
  }
}

}  // namespace
}  // namespace hexoderm
