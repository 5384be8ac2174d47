#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/text.h"
#include "hexoderm/io/xml_writing.h"

#include <cmath>
#include <pugixml.hpp>

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

}  // namespace hexoderm
