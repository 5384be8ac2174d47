// An MJCF model as MuJoCo itself loads and places it.

#include "tests/core/io/placed_skin.h"

#include <mujoco/mujoco.h>

namespace hexoderm {
namespace {

using MujocoReader = PlacedSkin;

SE3 fromMujoco(const mjtNum* position, const mjtNum* row_major) {
  return {Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(row_major),
          Eigen::Map<const Eigen::Vector3d>(position)};
}

TEST_F(MujocoReader, PlacesEveryBodyAndSite) {
  exportReconstruction(reconstruction_, ExportFormat::Mjcf, in("skin.xml"), options_);
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(
      mj_loadXML(in("skin.xml").c_str(), nullptr, error.data(), static_cast<int>(error.size())), mj_deleteModel);
  ASSERT_TRUE(model) << error.data();
  EXPECT_STREQ(error.data(), "");
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()), mj_deleteData);
  mj_forward(model.get(), data.get());

  const std::string sensor = "skin_cell3_accelerometer";
  expectOnLink([&](const std::string& name) {
    const int at = mj_name2id(model.get(), name == sensor ? mjOBJ_SITE : mjOBJ_BODY, name.c_str());
    EXPECT_GE(at, 0) << name;
    if (at < 0) return SE3();
    return name == sensor ? fromMujoco(data->site_xpos + 3 * at, data->site_xmat + 9 * at)
                          : fromMujoco(data->xpos + 3 * at, data->xmat + 9 * at);
  });
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_SENSOR, sensor.c_str()), 0);
  // The mesh is the prism, wherever MuJoCo has put its origin.
  ASSERT_EQ(model->nmeshvert, 12);
  const CellPlacement& cell = reconstruction_.patches[0].cells[2];
  const int geom = model->body_geomadr[mj_name2id(model.get(), mjOBJ_BODY, "skin_cell12")];
  EXPECT_STREQ(mj_id2name(model.get(), mjOBJ_MATERIAL, model->geom_matid[geom]), "hexoderm_over");
  const SE3 T_w_mesh = fromMujoco(data->geom_xpos + 3 * geom, data->geom_xmat + 9 * geom);
  const SE3 T_u_mesh = (T_l_o_ * cell.T_o_u).inverse() * T_w_mesh;
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 12; ++k) {
    corners.emplace_back(T_u_mesh * Eigen::Map<const Eigen::Vector3f>(model->mesh_vert + 3 * k).cast<double>());
  }
  const CellModel cell_model = builtInCellModel("hex-bma150");
  for (const Eigen::Vector3d& front : cell_model.outline()) {
    for (const double z : {0.0, -cell_model.thickness_m}) {
      const Eigen::Vector3d meant(front.x(), front.y(), z);
      EXPECT_TRUE(std::ranges::any_of(corners, [&](const auto& corner) { return (corner - meant).norm() < 1e-6; }));
    }
  }
}

}  // namespace
}  // namespace hexoderm
