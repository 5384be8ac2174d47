#include "hexoderm/io/export_formats.h"

#include "hexoderm/util/text.h"

#include <cmath>
#include <pugixml.hpp>
#include <sstream>

namespace hexoderm {
namespace {

constexpr const char* kAccelerometerType = "accelerometer";

std::string savedText(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, "  ");
  return std::move(out).str();
}

void declareXml(pugi::xml_document& document) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
}

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
  pugi::xml_node frame = model.append_child("frame");
  frame.append_attribute("name") = name.c_str();
  frame.append_attribute("attached_to") = parent.c_str();
  appendPose(frame, T);
}

std::string visualName(const SkinTreeCell& cell, std::size_t box) { return cell.name + "_" + std::to_string(box + 1); }

// MJCF

void placeMjcf(pugi::xml_node node, const SE3& T) {
  const Eigen::Quaterniond q = quaternionOf(T.R);
  node.append_attribute("pos") = vectorText(T.t).c_str();
  node.append_attribute("quat") = (formatExact(q.w()) + " " + vectorText(q.vec())).c_str();
}

pugi::xml_node appendBody(pugi::xml_node parent, const std::string& name, const SE3& T) {
  pugi::xml_node body = parent.append_child("body");
  body.append_attribute("name") = name.c_str();
  placeMjcf(body, T);
  return body;
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
  pugi::xml_node sdf = document.append_child("sdf");
  sdf.append_attribute("version") = "1.9";
  pugi::xml_node model = sdf.append_child("model");
  model.append_attribute("name") = tree.model.c_str();
  model.append_child(pugi::node_comment)
      .set_value((massComment(tree) + " The mass of the skin is not known; 1 g stands for it. ").c_str());
  pugi::xml_node link = model.append_child("link");
  link.append_attribute("name") = tree.links.front().c_str();
  pugi::xml_node inertial = link.append_child("inertial");
  inertial.append_child("mass").text().set("0.001");
  pugi::xml_node inertia = inertial.append_child("inertia");
  for (const char* diagonal : {"ixx", "iyy", "izz"}) inertia.append_child(diagonal).text().set("1e-06");
  const CellBoxes boxes = cellBoxes(tree);
  for (const SkinTreePatch& patch : tree.patches) {
    for (const SkinTreeCell& cell : patch.cells) {
      for (std::size_t k = 0; k < boxes.T_u_box.size(); ++k) {
        pugi::xml_node visual = link.append_child("visual");
        visual.append_attribute("name") = visualName(cell, k).c_str();
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
  return savedText(document);
}

std::string mjcfBytes(const SkinTree& tree) {
  pugi::xml_document document;
  pugi::xml_node mujoco = document.append_child("mujoco");
  mujoco.append_attribute("model") = tree.model.c_str();
  mujoco.append_child(pugi::node_comment).set_value((massComment(tree) + " ").c_str());
  mujoco.append_child("compiler").append_attribute("angle") = "radian";
  pugi::xml_node asset = mujoco.append_child("asset");
  pugi::xml_node mesh = asset.append_child("mesh");
  mesh.append_attribute("name") = "hexoderm_cell";
  mesh.append_attribute("vertex") = hexagonVertices(tree).c_str();
  for (const SkinMaterial& material : skinMaterials()) {
    pugi::xml_node node = asset.append_child("material");
    node.append_attribute("name") = material.name.c_str();
    node.append_attribute("rgba") = rgbaText(material.rgb).c_str();
  }
  pugi::xml_node robot_link = appendBody(mujoco.append_child("worldbody"), tree.links.front(), {});
  std::vector<std::string> accelerometers;
  for (const SkinTreePatch& patch : tree.patches) {
    pugi::xml_node patch_body = appendBody(robot_link, patch.name, patch.T_l_o);
    for (const SkinTreeCell& cell : patch.cells) {
      pugi::xml_node body = appendBody(patch_body, cell.name, cell.T_o_u);
      pugi::xml_node geom = body.append_child("geom");
      geom.append_attribute("type") = "mesh";
      geom.append_attribute("mesh") = "hexoderm_cell";
      geom.append_attribute("material") = cell.material.c_str();
      for (const char* zero : {"mass", "contype", "conaffinity"}) geom.append_attribute(zero) = "0";
      const SE3 T_u_o = cell.T_o_u.inverse();
      for (const SkinTreeSensor& sensor : cell.sensors) {
        pugi::xml_node site = body.append_child("site");
        site.append_attribute("name") = sensor.name.c_str();
        placeMjcf(site, T_u_o * sensor.T_o_s);
        if (sensor.type == kAccelerometerType) accelerometers.push_back(sensor.name);
      }
    }
  }
  if (accelerometers.empty()) return savedText(document);
  pugi::xml_node sensors = mujoco.append_child("sensor");
  for (const std::string& site : accelerometers) {
    pugi::xml_node sensor = sensors.append_child(kAccelerometerType);
    sensor.append_attribute("name") = site.c_str();
    sensor.append_attribute("site") = site.c_str();
  }
  return savedText(document);
}

}  // namespace hexoderm
