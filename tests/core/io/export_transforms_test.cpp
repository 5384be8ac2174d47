// Static transforms, as a YAML library and Python read them.

#include "tests/core/io/placed_skin.h"
#include "tests/support/other_programs.h"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

namespace hexoderm {
namespace {

/// x y z qx qy qz qw and the two frames of a transform.
struct Transform {
  std::vector<double> numbers;
  std::string parent;
};
using Transforms = std::map<std::string, Transform>;

class ExportTransforms : public PlacedSkin {
 protected:
  void SetUp() override {
    options_.placements.push_back({CellId(20), "hand", {}, {}});
    // A number that has no point in its shortest form, and one that is whole.
    reconstruction_.patches[0].cells[0].T_o_u.t = {1e-5, -2e-7, 1};
  }

  /// Every cell and sensor of the skin ends up where it is, in the link of its patch.
  void expectTheSkin(const Transforms& found) const {
    const auto placeIn = [&](std::string at, const std::string& root) {
      SE3 T;
      while (at != root && found.contains(at)) {
        const Transform& step = found.at(at);
        const std::vector<double>& n = step.numbers;
        EXPECT_EQ(n.size(), 7U);
        T = SE3{Eigen::Quaterniond(n[6], n[3], n[4], n[5]).toRotationMatrix(), {n[0], n[1], n[2]}} * T;
        at = step.parent;
      }
      EXPECT_EQ(at, root);
      return T;
    };
    expectOnLink([&](const std::string& name) { return placeIn(name, "forearm"); });
    EXPECT_THAT(placeIn("skin_cell20", "hand"), SE3Near(reconstruction_.patches[1].cells[0].T_o_u, 1e-9, 1e-9));
    std::size_t frames = 3;  // of the patches and the cell of the second
    for (const CellPlacement& cell : reconstruction_.patches[0].cells) frames += 1 + cell.sensors.size();
    EXPECT_EQ(found.size(), frames);
  }
};

TEST_F(ExportTransforms, OfRos1AreArgumentsOfStaticTransformPublisher) {
  exportReconstruction(reconstruction_, ExportFormat::TfRos1, in("skin.launch"), options_);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file(in("skin.launch").c_str()));
  Transforms found;
  std::set<std::string> nodes;
  for (const pugi::xml_node node : document.child("launch").children("node")) {
    EXPECT_TRUE(nodes.insert(node.attribute("name").value()).second) << node.attribute("name").value();
    EXPECT_STREQ(node.attribute("pkg").value(), "tf2_ros");
    EXPECT_STREQ(node.attribute("type").value(), "static_transform_publisher");
    std::istringstream args(node.attribute("args").value());
    Transform transform{std::vector<double>(7), ""};
    for (double& number : transform.numbers) args >> number;
    std::string child;
    args >> transform.parent >> child;
    found[child] = transform;
  }
  expectTheSkin(found);
}

TEST_F(ExportTransforms, OfRos2AreWhatItsLaunchFileGivesToTheNodes) {
  exportReconstruction(reconstruction_, ExportFormat::TfRos2, in("skin.launch.py"), options_);
  // Python runs the file, with classes in place of those of ROS 2 that keep what they are given.
  temporary_.put("run.py", R"(
import importlib.util, json, sys, types
class Node:
    def __init__(self, **words): self.words = words
for name, members in {"launch": {"LaunchDescription": list}, "launch_ros": {}, "launch_ros.actions": {"Node": Node}}.items():
    module = types.ModuleType(name)
    vars(module).update(members)
    sys.modules[name] = module
spec = importlib.util.spec_from_file_location("skin", sys.argv[1])
skin = importlib.util.module_from_spec(spec)
spec.loader.exec_module(skin)
print(json.dumps([node.words for node in skin.generate_launch_description()]))
)");
  const auto outcome = test::runProgram("python3 " + in("run.py").string() + " " + in("skin.launch.py").string());
  ASSERT_TRUE(outcome) << "there is no python3: packaging/setup.sh installs it";
  ASSERT_EQ(outcome->exit_code, 0) << outcome->out;
  Transforms found;
  std::set<std::string> nodes;
  for (const auto& node : nlohmann::json::parse(outcome->out)) {
    EXPECT_TRUE(nodes.insert(node.at("name").get<std::string>()).second) << node.at("name");
    EXPECT_EQ(node.at("package"), "tf2_ros");
    EXPECT_EQ(node.at("executable"), "static_transform_publisher");
    const auto words = node.at("arguments").get<std::vector<std::string>>();
    ASSERT_EQ(words.size(), 18U);
    std::map<std::string, std::string> values;
    for (std::size_t k = 0; k < words.size(); k += 2) values[words[k]] = words[k + 1];
    Transform transform{{}, values.at("--frame-id")};
    for (const char* option : {"--x", "--y", "--z", "--qx", "--qy", "--qz", "--qw"}) {
      transform.numbers.push_back(std::stod(values.at(option)));
    }
    found[values.at("--child-frame-id")] = transform;
  }
  expectTheSkin(found);
}

TEST_F(ExportTransforms, InYamlAreNumbersForAYamlLibrary) {
  exportReconstruction(reconstruction_, ExportFormat::TfYaml, in("skin.yaml"), options_);
  // Debian's own Python has Debian's python3-yaml.
  const auto outcome =
      test::runProgram("/usr/bin/python3 -c 'import json, sys, yaml; print(json.dumps(yaml.safe_load(open(\"" +
                       in("skin.yaml").string() + "\"))))'");
  ASSERT_TRUE(outcome) << "there is no python3: packaging/setup.sh installs it";
  ASSERT_EQ(outcome->exit_code, 0) << outcome->out;
  Transforms found;
  for (const auto& stamped : nlohmann::json::parse(outcome->out)) {
    const auto& transform = stamped.at("transform");
    Transform& added = found[stamped.at("child_frame_id").get<std::string>()];
    added.parent = stamped.at("header").at("frame_id").get<std::string>();
    for (const auto& [part, axes] : {std::pair("translation", "xyz"), std::pair("rotation", "xyzw")}) {
      for (const char axis : std::string(axes)) {
        const auto& number = transform.at(part).at(std::string(1, axis));
        ASSERT_TRUE(number.is_number_float()) << number;
        added.numbers.push_back(number.get<double>());
      }
    }
  }
  expectTheSkin(found);
}

TEST_F(ExportTransforms, OfPatchesAloneWhereCellsWouldBeTooMany) {
  options_.link_per_cell = false;
  exportReconstruction(reconstruction_, ExportFormat::TfRos1, in("skin.launch"), options_);
  const std::string text = readFile(in("skin.launch"));
  EXPECT_THAT(text, AllOf(HasSubstr("forearm skin_patch0"), HasSubstr("hand skin_patch1")));
  EXPECT_EQ(text.find("cell7"), std::string::npos);
}

}  // namespace
}  // namespace hexoderm
