#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/units.h"
#include "hexoderm/io/exporter.h"
#include "tests/core/io/urdf_places.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

#include <pugixml.hpp>
#include <sstream>

namespace hexoderm {
namespace {

using ::testing::UnorderedElementsAre;

/// What a file of the skin holds.
UrdfContent contentOf(const Reconstruction& reconstruction, const ExportOptions& options = {}) {
  const ExportSelection selection =
      selectForExport(reconstruction, exportFormatDescription(ExportFormat::Urdf), options);
  return {skinTree(*reconstruction.model, selection.mounted, reconstruction, options), options.link_per_cell,
          options.urdf_form};
}

/// Placement of every link in the root, as urdfdom reads them.
std::map<std::string, SE3> chained(const std::string& text) {
  std::map<std::string, SE3> T_root;
  const auto model = urdf::parseURDF(text);
  EXPECT_EQ(model->getRoot()->name, "base_link");
  for (const auto& [name, link] : model->links_) T_root[name] = test::placeIn(*model, name, "base_link");
  return T_root;
}

void expectNear(const SE3& found, const SE3& expected, const std::string& what) {
  EXPECT_LT((found.R - expected.R).norm(), 1e-9) << what;
  EXPECT_LT((found.t - expected.t).norm(), 1e-12) << what;
}

std::string urdfOf(const Reconstruction& reconstruction, const ExportOptions& options = {}) {
  return exportBytes(reconstruction, ExportFormat::Urdf, options);
}
pugi::xml_document exported(const Reconstruction& reconstruction, const ExportOptions& options = {}) {
  pugi::xml_document document;
  const std::string text = urdfOf(reconstruction, options);
  EXPECT_TRUE(document.load_buffer(text.data(), text.size()));
  return document;
}

TEST(ExportUrdf, ChainsToEveryCellAndSensor) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const auto T_root = chained(urdfOf(reconstruction));
  EXPECT_THAT(collect(T_root, &std::pair<const std::string, SE3>::first),
              UnorderedElementsAre("base_link", "skin_patch0", "skin_cell3", "skin_cell7", "skin_cell12",
                                   "skin_cell3_accelerometer", "skin_cell7_force_1_gr_e", "skin_cell7_force_1_gr_e_2",
                                   "skin_cell12_sensor"));
  const auto& cells = reconstruction.patches[0].cells;
  expectNear(T_root.at("skin_patch0"), {}, "patch");
  expectNear(T_root.at("skin_cell3"), cells[0].T_o_u, "cell 3");
  expectNear(T_root.at("skin_cell12"), cells[2].T_o_u, "cell 12, pitched by 90 degrees");
  expectNear(T_root.at("skin_cell3_accelerometer"), cells[0].sensors[0].T_o_s, "sensor of cell 3");
  expectNear(T_root.at("skin_cell12_sensor"), cells[2].sensors[0].T_o_s, "sensor of cell 12");
}

/// The corners of a box, in the frame of its link.
std::vector<Eigen::Vector3d> boxCorners(const urdf::Visual& visual) {
  const urdf::Vector3& size = dynamic_cast<const urdf::Box&>(*visual.geometry).dim;
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        corners.emplace_back(test::fromUrdf(visual.origin) * Eigen::Vector3d(x * size.x, y * size.y, z * size.z));
      }
    }
  }
  return corners;
}

TEST(ExportUrdf, DrawsCellsAsHexagonsBelowTheirFrontFace) {
  // The corners of the boxes are those of the prism, each of two boxes, and no others.
  const CellModel model = builtInCellModel("hex-bma150");
  std::vector<Eigen::Vector3d> prism;
  for (const Eigen::Vector3d& corner : model.outline()) {
    prism.push_back(corner);
    prism.emplace_back(corner - model.thickness_m * Eigen::Vector3d::UnitZ());
  }
  const Reconstruction reconstruction = makeTestReconstruction();
  const std::map<std::string, SE3> T_link_12 = {{"skin_cell12", {}},
                                                {"skin_patch0", reconstruction.patches[0].cells[2].T_o_u}};
  for (const auto& [name, T_link_u] : T_link_12) {
    const auto robot =
        urdf::parseURDF(urdfOf(reconstruction, test::with(&ExportOptions::link_per_cell, name == "skin_cell12")));
    std::vector<int> boxes_at(prism.size());
    int boxes = 0;
    for (const auto& visual : robot->getLink(name)->visual_array) {
      if (!visual->name.starts_with("skin_cell12_")) continue;
      ++boxes;
      EXPECT_EQ(visual->material_name, "hexoderm_over");
      for (const Eigen::Vector3d& in_link : boxCorners(*visual)) {
        const Eigen::Vector3d corner = T_link_u.inverse() * in_link;
        const auto near = std::ranges::min_element(
            prism, {}, [&](const Eigen::Vector3d& of_prism) { return (of_prism - corner).norm(); });
        EXPECT_LT((*near - corner).norm(), 1e-12);
        ++boxes_at[static_cast<std::size_t>(near - prism.begin())];
      }
    }
    EXPECT_EQ(boxes, 3) << name;
    EXPECT_THAT(boxes_at, ::testing::Each(2)) << name;
  }
}

TEST(ExportUrdf, OneLinkAPatchHoldsCellsAsVisualsAndSensorsAsElements) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const ExportOptions options = test::with(&ExportOptions::link_per_cell, false);
  EXPECT_EQ(chained(urdfOf(reconstruction, options)).size(), 2U);
  const auto document = exported(reconstruction, options);
  const pugi::xml_node robot = document.child("robot");
  const pugi::xml_node sensor = robot.find_child_by_attribute("sensor", "name", "skin_cell3_accelerometer");
  EXPECT_STREQ(sensor.child("parent").attribute("link").value(), "skin_patch0");
  Eigen::Vector3d xyz, rpy;
  std::istringstream(sensor.child("origin").attribute("xyz").value()) >> xyz.x() >> xyz.y() >> xyz.z();
  std::istringstream(sensor.child("origin").attribute("rpy").value()) >> rpy.x() >> rpy.y() >> rpy.z();
  const SE3& T_o_s = reconstruction.patches[0].cells[0].sensors[0].T_o_s;
  expectNear({rotationFromRpy(rpy), xyz}, T_o_s, "sensor of cell 3");
}

TEST(ExportUrdf, UsesTheNamesOfTheOptions) {
  ExportOptions options;
  options.model_name = "nao-6";
  options.parent_link = "l_forearm";
  options.prefix = "";
  const auto document = exported(makeTestReconstruction(), options);
  const pugi::xml_node robot = document.child("robot");
  EXPECT_STREQ(robot.attribute("name").value(), "nao-6");
  EXPECT_STREQ(robot.child("link").attribute("name").value(), "l_forearm");
  EXPECT_STREQ(robot.child("joint").attribute("name").value(), "patch0_joint");
  EXPECT_STREQ(robot.child("joint").child("parent").attribute("link").value(), "l_forearm");
}

TEST(ExportUrdf, RefusesAParentLinkThatTheSkinNeedsItself) {
  const ExportOptions options = test::with(&ExportOptions::parent_link, "skin_cell7");
  EXPECT_THAT(messageOf<InvalidArgument>([&] { contentOf(makeTestReconstruction(), options); }),
              HasSubstr("parent_link: \"skin_cell7\""));
}

TEST(ExportUrdf, EveryOrientationComesBack) {
  Reconstruction reconstruction = makeTestReconstruction();
  for (const double pitch_deg : {-90.0, -89.9999999, -45.0, 0.0, 89.99999, 89.9999999, 90.0}) {
    for (const double roll_deg : {-180.0, -170.0, 0.0, 33.0, 180.0}) {
      for (const double yaw_deg : {-180.0, -91.0, 0.0, 77.0}) {
        reconstruction.patches[0].cells[0].T_o_u.R =
            rotationFromRpy(kDegree * Eigen::Vector3d(roll_deg, pitch_deg, yaw_deg));
        const auto T_root = chained(urdfBytes(contentOf(reconstruction)));
        const CellPlacement& cell = reconstruction.patches[0].cells[0];
        for (const auto& [name, T] :
             {std::pair("skin_cell3", cell.T_o_u), std::pair("skin_cell3_accelerometer", cell.sensors[0].T_o_s)}) {
          EXPECT_LE((T_root.at(name).R - T.R).cwiseAbs().maxCoeff(), 1e-9)
              << name << " " << roll_deg << " " << pitch_deg << " " << yaw_deg;
          EXPECT_LE((T_root.at(name).t - T.t).cwiseAbs().maxCoeff(), 1e-9) << name;
        }
      }
    }
  }
}

TEST(ExportUrdf, TakesRotationsOfFewDecimals) {
  Reconstruction reconstruction = makeTestReconstruction();
  Eigen::Matrix3d& R = reconstruction.patches[0].cells[0].T_o_u.R;
  R = (R * 1e7).array().round() / 1e7;
  EXPECT_NO_THROW(exported(reconstruction));
}

TEST(ExportUrdf, EmptyReconstructionGivesTheParentLinkAlone) {
  EXPECT_EQ(chained(urdfOf(test::ResultBuilder().build())).size(), 1U);
}

TEST(ExportUrdf, APartLeavesTheParentLinksToTheRobot) {
  ExportOptions options;
  options.urdf_form = UrdfForm::Part;
  options.placements = {{CellId(20), "hand", {}, {}}, {CellId(7), "elbow", {}, {}}};
  const auto document = exported(makeTestReconstruction(), options);
  const pugi::xml_node robot = document.child("robot");
  for (const char* link : {"hand", "elbow"}) EXPECT_FALSE(robot.find_child_by_attribute("link", "name", link)) << link;
  const auto parentOf = [&](const char* joint) {
    return std::string(robot.find_child_by_attribute("joint", "name", joint).child("parent").attribute("link").value());
  };
  EXPECT_EQ(parentOf("skin_patch0_joint"), "elbow");
  EXPECT_EQ(parentOf("skin_patch1_joint"), "hand");
}

/// What xacro makes of a call of a macro without arguments: its parameters by their defaults.
std::string expanded(std::string body, const std::map<std::string, std::string>& values) {
  for (const auto& [name, value] : values) {
    for (std::size_t at = body.find("${" + name + "}"); at != std::string::npos; at = body.find("${" + name + "}")) {
      body.replace(at, name.size() + 3, value);
    }
  }
  return body;
}

TEST(ExportUrdf, AMacroIsTheSkinWithItsOriginAsParameters) {
  const Reconstruction reconstruction = makeTestReconstruction();
  ExportOptions options;
  options.urdf_form = UrdfForm::Macro;
  options.placements = {{CellId(7), "elbow", {Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.3}}, {}}};
  const auto document = exported(reconstruction, options);
  const pugi::xml_node macro = document.child("robot").child("xacro:macro");
  EXPECT_STREQ(macro.attribute("name").value(), "skin_patch0");
  EXPECT_STREQ(macro.attribute("params").value(), "parent:=elbow xyz:='0.1 0.2 0.3' rpy:='0 0 0'");
  std::ostringstream body;
  for (const pugi::xml_node node : document.child("robot").children("material")) node.print(body);
  for (const pugi::xml_node node : macro.children()) node.print(body);
  const std::string robot =
      "<robot name=\"r\"><link name=\"base_link\"/>" +
      expanded(body.str(), {{"parent", "base_link"}, {"xyz", "1 2 3"}, {"rpy", "0 0 1.5707963267948966"}}) + "</robot>";
  const SE3 T_l_o{rotationFromRpy({0, 0, 1.5707963267948966}), {1, 2, 3}};
  expectNear(chained(robot).at("skin_cell3"), T_l_o * reconstruction.patches[0].cells[0].T_o_u, "cell 3");
  options.prefix = "left/";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { exported(reconstruction, options); }), HasSubstr("left/patch0"));
}

TEST(LinkName, TakesWhatUrdfAndTfTake) {
  for (const char* name : {"base_link", "r-arm.2", "left/forearm", "7"}) EXPECT_TRUE(isLinkName(name)) << name;
  for (const char* name : {"", "/base", "base link", "größe", "a\"b", "a<b"}) EXPECT_FALSE(isLinkName(name)) << name;
}

}  // namespace
}  // namespace hexoderm
