// An SDF model as libsdformat, Gazebo's reader, resolves it.

#include "tests/core/io/placed_skin.h"

#include <sdf/sdf.hh>

namespace hexoderm {
namespace {

SE3 fromPose(const ignition::math::Pose3d& pose) {
  const Eigen::Quaterniond q(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z());
  return {q.toRotationMatrix(), {pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()}};
}

using SdformatReader = PlacedSkin;

TEST_F(SdformatReader, FindsEveryCellAndSensorInTheLink) {
  options_.model_name = "arm_skin";
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(bytes(ExportFormat::Sdf));
  for (const sdf::Error& error : errors) ADD_FAILURE() << error.Message();
  const sdf::Model* model = root.Model();
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->Name(), "arm_skin");
  expectOnLink([&](const std::string& name) {
    ignition::math::Pose3d pose;
    const sdf::Frame* frame = model->FrameByName(name);
    EXPECT_NE(frame, nullptr) << name;
    if (frame == nullptr) return SE3();
    for (const sdf::Error& error : frame->SemanticPose().Resolve(pose, "forearm")) ADD_FAILURE() << error.Message();
    return fromPose(pose);
  });
  const sdf::Link* link = model->LinkByName("forearm");
  ASSERT_NE(link, nullptr);
  EXPECT_EQ(link->VisualCount(), 9U) << "three boxes a cell";
  // The corners of the boxes are those of the prisms.
  const CellModel cell_model = builtInCellModel("hex-bma150");
  for (std::uint64_t k = 0; k < link->VisualCount(); ++k) {
    const sdf::Visual* visual = link->VisualByIndex(k);
    const CellPlacement& cell = reconstruction_.patches[0].cells[k / 3];
    EXPECT_EQ(visual->Name(), "skin_cell" + toString(cell.cell) + "_" + std::to_string(k % 3 + 1));
    ASSERT_EQ(visual->Geom()->Type(), sdf::GeometryType::BOX);
    const ignition::math::Vector3d& size = visual->Geom()->BoxShape()->Size();
    const SE3 T_u_box = (T_l_o_ * cell.T_o_u).inverse() * fromPose(visual->RawPose());
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
