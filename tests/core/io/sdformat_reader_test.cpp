// An SDF model as libsdformat, Gazebo's reader, resolves it.

#include "hexoderm/io/exporter.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>
#include <sdf/sdf.hh>

namespace hexoderm {
namespace {

SE3 fromPose(const ignition::math::Pose3d& pose) {
  const Eigen::Quaterniond q(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z());
  return {q.toRotationMatrix(), {pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()}};
}

TEST(SdformatReader, FindsEveryCellAndSensorInTheLink) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const SE3 T_l_o{rotationFromRpy({0.4, -0.9, 2.5}), {0.03, -0.01, 0.12}};
  ExportOptions options;
  options.model_name = "arm_skin";
  options.placements = {{CellId(7), "forearm", T_l_o, {}}};
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(exportBytes(reconstruction, ExportFormat::Sdf, options, "skin.sdf"));
  for (const sdf::Error& error : errors) ADD_FAILURE() << error.Message();
  const sdf::Model* model = root.Model();
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->Name(), "arm_skin");
  const auto expectFrame = [&](const std::string& name, const SE3& T) {
    const sdf::Frame* frame = model->FrameByName(name);
    ASSERT_NE(frame, nullptr) << name;
    ignition::math::Pose3d pose;
    for (const sdf::Error& error : frame->SemanticPose().Resolve(pose, "forearm")) ADD_FAILURE() << error.Message();
    const SE3 found = fromPose(pose);
    EXPECT_LT((found.R - T.R).norm(), 1e-9) << name;
    EXPECT_LT((found.t - T.t).norm(), 1e-9) << name;
  };
  for (const CellPlacement& cell : reconstruction.patches[0].cells) {
    expectFrame("skin_cell" + toString(cell.cell), T_l_o * cell.T_o_u);
  }
  expectFrame("skin_cell3_accelerometer", T_l_o * reconstruction.patches[0].cells[0].sensors[0].T_o_s);
  const sdf::Link* link = model->LinkByName("forearm");
  ASSERT_NE(link, nullptr);
  EXPECT_EQ(link->VisualCount(), 9U) << "three boxes a cell";
  EXPECT_EQ(link->VisualByIndex(0)->Geom()->Type(), sdf::GeometryType::BOX);
}

}  // namespace
}  // namespace hexoderm
