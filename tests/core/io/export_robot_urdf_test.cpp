// The robot's URDF with the skin on it, as urdfdom and check_urdf read it.

#include "tests/core/io/placed_skin.h"
#include "tests/core/io/urdf_places.h"
#include "tests/support/other_programs.h"

namespace hexoderm {
namespace {

/// Two joints that move, a comment that ends the robot in vain, and attributes in both kinds of quotes.
constexpr const char* kRobot = R"(<?xml version="1.0"?>
<!-- An arm.   Written   by hand; </robot> stands here, too. -->
<robot name='arm'>
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base_link"/>
  <link name='upper_arm'><visual><geometry><box size="0.1 0.1 0.3"/></geometry></visual></link>
  <link name="forearm"/>
  <joint name="shoulder" type="revolute">
    <parent link="base_link"/><child link="upper_arm"/>
    <origin xyz="0 0 0.2" rpy="0.3 0 0"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
  <joint name="elbow" type="revolute">
    <parent link="upper_arm"/><child link="forearm"/>
    <origin xyz="0 0 0.3" rpy="0 0 0.7"/><axis xyz="1 0 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
</robot>
<!-- </robot> -->
)";

class ExportRobotUrdf : public PlacedSkin {
 protected:
  void SetUp() override {
    temporary_.put("robot.urdf", kRobot);
    options_.robot_urdf = in("robot.urdf");
    options_.placements.push_back({CellId(20), "upper_arm", T_upper_20_, {}});
  }
  std::string exported() {
    exportReconstruction(reconstruction_, ExportFormat::RobotUrdf, in("with_skin.urdf"), options_);
    return readFile(in("with_skin.urdf"));
  }
  std::string refused() {
    return messageOf<Error>(
        [&] { exportReconstruction(reconstruction_, ExportFormat::RobotUrdf, in("with_skin.urdf"), options_); });
  }

  const SE3 T_upper_20_{rotationFromRpy({-1.4, 0.2, 0.5}), {0.0, 0.05, 0.2}};
};

TEST_F(ExportRobotUrdf, AddsToTheGivenTextAndChangesNoByteOfIt) {
  const std::string robot = kRobot;
  for (const std::string& text :
       {robot, replaced(robot, "\n</robot>", "</robot>"), replaced(robot, "\n</robot>", "\r\n  </robot >")}) {
    temporary_.put("robot.urdf", text);
    const std::string found = exported();
    const std::size_t begin = static_cast<std::size_t>(std::ranges::mismatch(text, found).in1 - text.begin());
    const std::string rest = text.substr(begin);
    EXPECT_TRUE(found.ends_with(rest)) << found;
    const std::string added = found.substr(begin, found.size() - text.size());
    EXPECT_THAT(added, AllOf(HasSubstr("skin_cell7"), HasSubstr("skin_cell20")));
    EXPECT_EQ(added.find("name=\"forearm\""), std::string::npos) << "the parent link is not defined again";
  }
}

TEST_F(ExportRobotUrdf, IsReadByUrdfdom) {
  const auto model = urdf::parseURDF(exported());
  ASSERT_TRUE(model);
  expectOnLink([&](const std::string& link) { return test::placeIn(*model, link, "forearm"); });
  EXPECT_THAT(test::placeIn(*model, "skin_cell20", "upper_arm"), SE3Near(T_upper_20_, 1e-9, 1e-9));
  EXPECT_EQ(model->links_.size(), 3U + 2U + 4U + 4U) << "the robot, patches, cells and sensors";
  EXPECT_EQ(model->getLink("skin_cell12")->visual_array.size(), 3U);
  EXPECT_EQ(model->getLink("skin_cell12")->visual->material->name, "hexoderm_over");
}

TEST_F(ExportRobotUrdf, IsFoundGoodByCheckUrdf) {
  for (const bool link_per_cell : {true, false}) {
    options_.link_per_cell = link_per_cell;
    exported();
    const auto check = test::runProgram("check_urdf " + in("with_skin.urdf").string());
    ASSERT_TRUE(check) << "there is no check_urdf: packaging/setup.sh --tests installs it";
    EXPECT_EQ(check->exit_code, 0) << check->out;
    EXPECT_THAT(check->out, AllOf(HasSubstr("Successfully Parsed XML"), HasSubstr("skin_patch0")));
  }
}

TEST_F(ExportRobotUrdf, ASecondSkinWithAnotherPrefixUsesTheMaterialsOfTheFirst) {
  options_.placements.pop_back();
  temporary_.put("robot.urdf", exported());
  EXPECT_THAT(refused(), AllOf(HasSubstr("robot.urdf: already has a link skin_patch0"), HasSubstr("prefix")));
  options_.prefix = "back_";
  const auto model = urdf::parseURDF(exported());
  ASSERT_TRUE(model);
  EXPECT_TRUE(model->getLink("skin_cell7") && model->getLink("back_cell7"));
}

TEST_F(ExportRobotUrdf, RefusesWhatItCannotBePutOnAndKeepsTheEarlierFile) {
  const std::string earlier = exported();
  const std::map<std::string, std::string> robots = {
      {replaced(replaced(kRobot, "forearm\"/>", "for_arm\"/>"), "link=\"forearm\"", "link=\"for_arm\""),
       "the robot has no link forearm"},
      {replaced(kRobot, "<link name=\"base_link\"/>",
                "<link name=\"base_link\"/><link name=\"skin_cell3\"/><joint name=\"j\" type=\"fixed\">"
                "<parent link=\"base_link\"/><child link=\"skin_cell3\"/></joint>"),
       "already has a link skin_cell3"},
      {replaced(kRobot, "name=\"elbow\"", "name=\"skin_cell12_joint\""), "already has a joint skin_cell12_joint"},
      {replaced(kRobot, "<joint name=\"elbow\"", "<jo"), "line "},
      {"<sdf version=\"1.9\"/>", "sdf"},
      {"<robot name=\"arm\"/>", "link"},
      {"", "URDF"},
      {replaced(kRobot, "<link name=\"forearm\"/>", "<xacro:include filename=\"forearm.xacro\"/>"), "xacro"},
  };
  for (const auto& [robot, why] : robots) {
    temporary_.put("robot.urdf", robot);
    EXPECT_THAT(refused(), AllOf(HasSubstr("robot.urdf: "), HasSubstr(why)));
    EXPECT_EQ(readFile(in("with_skin.urdf")), earlier);
  }
  options_.robot_urdf = in("missing.urdf");
  EXPECT_THAT(refused(), HasSubstr("missing.urdf"));
  options_.robot_urdf.clear();
  EXPECT_THAT(refused(), HasSubstr("robot: expected the URDF of the robot"));
}

}  // namespace
}  // namespace hexoderm
