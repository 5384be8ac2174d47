#include "hexoderm/base/text.h"
#include "hexoderm/io/export_formats.h"
#include "hexoderm/io/xml_writing.h"

#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <set>

namespace hexoderm {
namespace {

constexpr const char* kAccelerometerType = "accelerometer";

std::uint32_t colorOfMaterial(const std::string& name) {
  for (const SkinMaterial& material : skinMaterials()) {
    if (material.name == name) return material.rgb;
  }
  return 0;
}

std::string massComment(const SkinTree& tree) {
  std::string text = " Metres and radians.";
  for (const SkinTreePatch& patch : tree.patches) {
    text += " " + patch.name +
            (patch.placed ? " is placed on " + patch.link + "."
                          : " is in " + patch.link + " without any offset: placing it is up to you.");
  }
  return text;
}

// SDF

void appendPose(pugi::xml_node node, const SE3& T) {
  node.append_child("pose").text().set((vectorText(T.t) + " " + vectorText(rpyFromRotation(T.R))).c_str());
}

void appendFrame(pugi::xml_node model, const std::string& name, const std::string& parent, const SE3& T) {
  appendPose(appendElement(model, "frame", {{"name", name}, {"attached_to", parent}}), T);
}

// MJCF

/// A body or a site at a place.
pugi::xml_node appendPlaced(pugi::xml_node parent, const char* element, const std::string& name, const SE3& T) {
  const Eigen::Quaterniond q = quaternionOf(T.R);
  return appendElement(
      parent, element,
      {{"name", name}, {"pos", vectorText(T.t)}, {"quat", formatExact(q.w()) + " " + vectorText(q.vec())}});
}

/// The twelve corners of a cell in its frame.
std::string hexagonVertices(const SkinTree& tree) {
  std::string text;
  for (const double z : {0.0, -tree.thickness_m}) {
    for (int corner = 0; corner < 6; ++corner) {
      const double angle = tree.side_angle_rad + corner * std::acos(0.5);
      const Eigen::Vector3d point(tree.side_m * std::cos(angle), tree.side_m * std::sin(angle), z);
      text += (text.empty() ? "" : "  ") + vectorText(point);
    }
  }
  return text;
}

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

std::string sdfBytes(const SkinTree& tree) {
  pugi::xml_document document;
  declareXml(document);
  pugi::xml_node model =
      appendElement(appendElement(document, "sdf", {{"version", "1.9"}}), "model", {{"name", tree.model}});
  appendComment(model, massComment(tree) + " The mass of the skin is not known; 1 g stands for it. ");
  pugi::xml_node link = appendElement(model, "link", {{"name", tree.links.front()}});
  pugi::xml_node inertial = link.append_child("inertial");
  inertial.append_child("mass").text().set("0.001");
  pugi::xml_node inertia = inertial.append_child("inertia");
  for (const char* diagonal : {"ixx", "iyy", "izz"}) inertia.append_child(diagonal).text().set("1e-06");
  const CellBoxes boxes = cellBoxes(tree);
  for (const SkinTreePatch& patch : tree.patches) {
    for (const SkinTreeCell& cell : patch.cells) {
      for (std::size_t k = 0; k < boxes.T_u_box.size(); ++k) {
        pugi::xml_node visual = appendElement(link, "visual", {{"name", boxName(cell, k)}});
        appendPose(visual, patch.T_l_o * cell.T_o_u * boxes.T_u_box[k]);
        visual.append_child("geometry")
            .append_child("box")
            .append_child("size")
            .text()
            .set(vectorText(boxes.size_m).c_str());
        pugi::xml_node material = visual.append_child("material");
        const std::string rgba = rgbaText(colorOfMaterial(cell.material));
        for (const char* kind : {"ambient", "diffuse"}) material.append_child(kind).text().set(rgba.c_str());
      }
    }
  }
  for (const SkinFrame& frame : skinFrames(tree, true)) {
    appendFrame(model, frame.name, frame.parent, frame.T_parent_frame);
  }
  return xmlText(document, "  ");
}

std::string mjcfBytes(const SkinTree& tree) {
  pugi::xml_document document;
  pugi::xml_node mujoco = appendElement(document, "mujoco", {{"model", tree.model}});
  appendComment(mujoco, massComment(tree) + " ");
  appendElement(mujoco, "compiler", {{"angle", "radian"}});
  pugi::xml_node asset = mujoco.append_child("asset");
  appendElement(asset, "mesh", {{"name", "hexoderm_cell"}, {"vertex", hexagonVertices(tree)}});
  for (const SkinMaterial& material : skinMaterials()) {
    appendElement(asset, "material", {{"name", material.name}, {"rgba", rgbaText(material.rgb)}});
  }
  pugi::xml_node robot_link = appendPlaced(mujoco.append_child("worldbody"), "body", tree.links.front(), {});
  std::vector<std::string> accelerometers;
  for (const SkinTreePatch& patch : tree.patches) {
    pugi::xml_node patch_body = appendPlaced(robot_link, "body", patch.name, patch.T_l_o);
    for (const SkinTreeCell& cell : patch.cells) {
      pugi::xml_node body = appendPlaced(patch_body, "body", cell.name, cell.T_o_u);
      appendElement(body, "geom",
                    {{"type", "mesh"},
                     {"mesh", "hexoderm_cell"},
                     {"material", cell.material},
                     {"mass", "0"},
                     {"contype", "0"},
                     {"conaffinity", "0"}});
      const SE3 T_u_o = cell.T_o_u.inverse();
      for (const SkinTreeSensor& sensor : cell.sensors) {
        appendPlaced(body, "site", sensor.name, T_u_o * sensor.T_o_s);
        if (sensor.type == kAccelerometerType) accelerometers.push_back(sensor.name);
      }
    }
  }
  if (accelerometers.empty()) return xmlText(document, "  ");
  pugi::xml_node sensors = mujoco.append_child("sensor");
  for (const std::string& site : accelerometers) {
    appendElement(sensors, kAccelerometerType, {{"name", site}, {"site", site}});
  }
  return xmlText(document, "  ");
}

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
