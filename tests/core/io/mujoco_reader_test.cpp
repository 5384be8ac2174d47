// An MJCF model as MuJoCo itself loads and places it.

#include "hexoderm/io/exporter.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <string>

namespace hexoderm {
namespace {

using MujocoReader = ExportTest;

SE3 fromMujoco(const mjtNum* position, const mjtNum* row_major) {
  return {Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(row_major),
          Eigen::Map<const Eigen::Vector3d>(position)};
}

TEST_F(MujocoReader, PlacesEveryBodyAndSite) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const SE3 T_l_o{rotationFromRpy({0.4, -0.9, 2.5}), {0.03, -0.01, 0.12}};
  ExportOptions options;
  options.placements = {{CellId(7), "forearm", T_l_o, {}}};
  exportReconstruction(reconstruction, ExportFormat::Mjcf, in("skin.xml"), options);
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(
      mj_loadXML(in("skin.xml").c_str(), nullptr, error.data(), static_cast<int>(error.size())), mj_deleteModel);
  ASSERT_TRUE(model) << error.data();
  EXPECT_STREQ(error.data(), "");
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()), mj_deleteData);
  mj_forward(model.get(), data.get());

  const auto expectNear = [](const SE3& found, const SE3& T, const std::string& name) {
    EXPECT_LT((found.R - T.R).norm(), 1e-9) << name;
    EXPECT_LT((found.t - T.t).norm(), 1e-9) << name;
  };
  for (const CellPlacement& cell : reconstruction.patches[0].cells) {
    const std::string name = "skin_cell" + toString(cell.cell);
    const int body = mj_name2id(model.get(), mjOBJ_BODY, name.c_str());
    ASSERT_GE(body, 0) << name;
    expectNear(fromMujoco(data->xpos + 3 * body, data->xmat + 9 * body), T_l_o * cell.T_o_u, name);
  }
  const std::string sensor = "skin_cell3_accelerometer";
  const int site = mj_name2id(model.get(), mjOBJ_SITE, sensor.c_str());
  ASSERT_GE(site, 0);
  expectNear(fromMujoco(data->site_xpos + 3 * site, data->site_xmat + 9 * site),
             T_l_o * reconstruction.patches[0].cells[0].sensors[0].T_o_s, sensor);
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_SENSOR, sensor.c_str()), 0);
  // The mesh is the hexagon: as high as the cell is thick, as wide as from corner to corner.
  ASSERT_EQ(model->nmeshvert, 12);
}

}  // namespace
}  // namespace hexoderm
