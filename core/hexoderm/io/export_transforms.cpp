#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/text.h"
#include "hexoderm/io/xml_writing.h"

#include <array>
#include <pugixml.hpp>
#include <set>

namespace hexoderm {
namespace {

/// x y z qx qy qz qw, as TF's programs take them.
std::array<double, 7> transformNumbers(const SE3& T) {
  const Eigen::Quaterniond q = quaternionOf(T.R);
  std::array<double, 7> numbers = {T.t.x(), T.t.y(), T.t.z(), q.x(), q.y(), q.z(), q.w()};
  for (double& number : numbers) number += 0.0;  // no "-0"
  return numbers;
}

/// The names of nodes in ROS have letters, digits and underscores only; no two are the same.
class NodeNames {
 public:
  std::string of(const std::string& frame) {
    std::string name = "static_tf_";
    for (const char c : frame) name += (c == '-' || c == '.' || c == '/') ? '_' : c;
    std::string unique = name;
    for (int k = 2; !taken_.insert(unique).second; ++k) unique = name + "_" + std::to_string(k);
    return unique;
  }

 private:
  std::set<std::string> taken_;
};

/// YAML 1.1 takes "1e-05" as a text: a number with an exponent needs a point, and one without looks whole.
std::string yamlNumber(double value) {
  std::string text = formatExact(value);
  if (text.find('.') != std::string::npos) return text;
  const std::size_t exponent = text.find('e');
  return exponent == std::string::npos ? text + ".0" : text.insert(exponent, ".0");
}

}  // namespace

std::string rosLaunchText(const std::vector<SkinFrame>& frames) {
  pugi::xml_document document;
  pugi::xml_node launch = document.append_child("launch");
  appendComment(launch,
                " Metres; x y z qx qy qz qw parent child. A node for each frame: of many cells, one link per patch, or "
                "the list of transforms in YAML, starts faster. ");
  NodeNames names;
  for (const SkinFrame& frame : frames) {
    std::string args;
    for (const double number : transformNumbers(frame.T_parent_frame)) args += formatExact(number) + " ";
    appendElement(launch, "node",
                  {{"pkg", "tf2_ros"},
                   {"type", "static_transform_publisher"},
                   {"name", names.of(frame.name)},
                   {"args", args + frame.parent + " " + frame.name}});
  }
  return xmlText(document, "  ");
}

std::string ros2LaunchText(const std::vector<SkinFrame>& frames) {
  std::string text =
      "# Static transforms of the skin, metres.\n"
      "from launch import LaunchDescription\n"
      "from launch_ros.actions import Node\n"
      "\n"
      "TRANSFORMS = [\n"
      "    # node, x, y, z, qx, qy, qz, qw, frame, child frame\n";
  NodeNames names;
  for (const SkinFrame& frame : frames) {
    text += "    (\"" + names.of(frame.name) + "\"";
    for (const double number : transformNumbers(frame.T_parent_frame)) text += ", \"" + formatExact(number) + "\"";
    text += ", \"" + frame.parent + "\", \"" + frame.name + "\"),\n";
  }
  return text +
         "]\n"
         "OPTIONS = [\"--x\", \"--y\", \"--z\", \"--qx\", \"--qy\", \"--qz\", \"--qw\", \"--frame-id\", "
         "\"--child-frame-id\"]\n"
         "\n"
         "\n"
         "def generate_launch_description():\n"
         "    return LaunchDescription([\n"
         "        Node(\n"
         "            package=\"tf2_ros\",\n"
         "            executable=\"static_transform_publisher\",\n"
         "            name=name,\n"
         "            arguments=[word for pair in zip(OPTIONS, values) for word in pair],\n"
         "        )\n"
         "        for name, *values in TRANSFORMS\n"
         "    ])\n";
}

std::string transformsYaml(const std::vector<SkinFrame>& frames) {
  std::string text = "# geometry_msgs/TransformStamped of each frame of the skin, metres.\n";
  if (frames.empty()) return text + "[]\n";
  for (const SkinFrame& frame : frames) {
    const std::array<double, 7> n = transformNumbers(frame.T_parent_frame);
    text += "- header:\n    stamp: {sec: 0, nanosec: 0}\n    frame_id: \"" + frame.parent + "\"\n  child_frame_id: \"" +
            frame.name + "\"\n  transform:\n    translation: {x: " + yamlNumber(n[0]) + ", y: " + yamlNumber(n[1]) +
            ", z: " + yamlNumber(n[2]) + "}\n    rotation: {x: " + yamlNumber(n[3]) + ", y: " + yamlNumber(n[4]) +
            ", z: " + yamlNumber(n[5]) + ", w: " + yamlNumber(n[6]) + "}\n";
  }
  return text;
}

}  // namespace hexoderm
