// An SDF model as libsdformat, Gazebo's reader, resolves it.

#include "hexoderm/io/exporter.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>
#include <sdf/sdf.hh>

#include <algorithm>
#include <string>

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
  // The corners of the boxes are those of the prisms.
  const CellModel cell_model = builtInCellModel("hex-bma150");
  for (std::uint64_t k = 0; k < link->VisualCount(); ++k) {
    const sdf::Visual* visual = link->VisualByIndex(k);
    const CellPlacement& cell = reconstruction.patches[0].cells[k / 3];
    EXPECT_EQ(visual->Name(), "skin_cell" + toString(cell.cell) + "_" + std::to_string(k % 3 + 1));
    ASSERT_EQ(visual->Geom()->Type(), sdf::GeometryType::BOX);
    const ignition::math::Vector3d& size = visual->Geom()->BoxShape()->Size();
    const SE3 T_u_box = (T_l_o * cell.T_o_u).inverse() * fromPose(visual->RawPose());
    for (const double sign : {-0.5, 0.5}) {
      const Eigen::Vector3d corner = T_u_box * Eigen::Vector3d(sign * size.X(), 0.5 * size.Y(), 0.5 * size.Z());
      const auto outline = cell_model.outline();
      EXPECT_TRUE(std::ranges::any_of(outline, [&](const auto& of_cell) { return (of_cell - corner).norm() < 1e-9; }))
          << visual->Name();
    }
    EXPECT_NEAR(size.Z(), cell_model.thickness_m, 1e-12);
  }
}

}  // namespace
}  // namespace hexoderm
