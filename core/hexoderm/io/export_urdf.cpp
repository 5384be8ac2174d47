#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/text.h"
#include "hexoderm/io/xml_writing.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

namespace hexoderm {
namespace {

/// A robot with all its links; meshes are files of their own.
constexpr std::uintmax_t kMaxRobotBytes = 50'000'000;

void appendOrigin(pugi::xml_node parent, const SE3& T) {
  appendElement(parent, "origin", {{"xyz", vectorText(T.t)}, {"rpy", vectorText(rpyFromRotation(T.R))}});
}

/// The prism of a cell, in a link in whose frame the cell is at `T_link_u`.
void appendVisuals(pugi::xml_node link, const SkinTreeCell& cell, const SE3& T_link_u, const CellBoxes& boxes) {
  for (std::size_t k = 0; k < boxes.T_u_box.size(); ++k) {
    pugi::xml_node visual = appendElement(link, "visual", {{"name", boxName(cell, k)}});
    appendOrigin(visual, T_link_u * boxes.T_u_box[k]);
    appendElement(visual.append_child("geometry"), "box", {{"size", vectorText(boxes.size_m)}});
    appendElement(visual, "material", {{"name", cell.material}});
  }
}

void appendMaterials(pugi::xml_node robot, const std::set<std::string>& there) {
  for (const SkinMaterial& material : skinMaterials()) {
    if (there.contains(material.name)) continue;
    appendElement(appendElement(robot, "material", {{"name", material.name}}), "color",
                  {{"rgba", rgbaText(material.rgb)}});
  }
}

pugi::xml_node appendJoint(pugi::xml_node robot, const std::string& child, const std::string& parent) {
  pugi::xml_node joint = appendElement(robot, "joint", {{"name", child + "_joint"}, {"type", "fixed"}});
  appendElement(joint, "parent", {{"link", parent}});
  appendElement(joint, "child", {{"link", child}});
  return joint;
}

pugi::xml_node appendLink(pugi::xml_node robot, const std::string& name) {
  return appendElement(robot, "link", {{"name", name}});
}

/// The links of a patch and the joints within it, without the one that fixes it to the robot.
void appendInside(pugi::xml_node robot, const SkinTreePatch& patch, const CellBoxes& boxes, bool link_per_cell) {
  pugi::xml_node patch_link = appendLink(robot, patch.name);
  if (!link_per_cell) {
    for (const SkinTreeCell& cell : patch.cells) appendVisuals(patch_link, cell, cell.T_o_u, boxes);
    for (const SkinTreeCell& cell : patch.cells) {
      for (const SkinTreeSensor& sensor : cell.sensors) {
        pugi::xml_node node = appendElement(robot, "sensor", {{"name", sensor.name}});
        appendElement(node, "parent", {{"link", patch.name}});
        appendOrigin(node, sensor.T_o_s);
      }
    }
    return;
  }
  for (const SkinTreeCell& cell : patch.cells) {
    appendOrigin(appendJoint(robot, cell.name, patch.name), cell.T_o_u);
    appendVisuals(appendLink(robot, cell.name), cell, {}, boxes);
    const SE3 T_u_o = cell.T_o_u.inverse();
    for (const SkinTreeSensor& sensor : cell.sensors) {
      appendOrigin(appendJoint(robot, sensor.name, cell.name), T_u_o * sensor.T_o_s);
      appendLink(robot, sensor.name);
    }
  }
}

void appendPatch(pugi::xml_node robot, const SkinTreePatch& patch, const CellBoxes& boxes, bool link_per_cell) {
  appendOrigin(appendJoint(robot, patch.name, patch.link), patch.T_l_o);
  appendInside(robot, patch, boxes, link_per_cell);
}

constexpr const char* kXacroNamespace = "http://www.ros.org/wiki/xacro";

void appendMacro(pugi::xml_node robot, const SkinTreePatch& patch, const CellBoxes& boxes, bool link_per_cell) {
  if (patch.name.find('/') != std::string::npos) {
    throw InvalidArgument("prefix", message("\"{}\" is no name for a xacro macro: leave out the /", patch.name));
  }
  pugi::xml_node macro = appendElement(robot, "xacro:macro",
                                       {{"name", patch.name},
                                        {"params", "parent:=" + patch.link + " xyz:='" + vectorText(patch.T_l_o.t) +
                                                       "' rpy:='" + vectorText(rpyFromRotation(patch.T_l_o.R)) + "'"}});
  appendElement(appendJoint(macro, patch.name, "${parent}"), "origin", {{"xyz", "${xyz}"}, {"rpy", "${rpy}"}});
  appendInside(macro, patch, boxes, link_per_cell);
}

std::string commentOf(const UrdfContent& content) {
  std::string text = " Metres and radians.";
  for (const SkinTreePatch& patch : content.tree.patches) {
    text += " " + patch.name + " is in the frame of cell " + toString(patch.origin) + ", the origin of the patch" +
            (patch.placed ? ", placed on " + patch.link + "."
                          : ", joined to " + patch.link + " without any offset: placing it on the robot is up to you.");
  }
  if (content.form == UrdfForm::Part) text += " The links that the patches are joined to are defined by the robot.";
  if (content.form == UrdfForm::Macro) text += " Include the file, then call the macro of each patch.";
  return text + " ";
}

/// Where the last </robot> stands that is neither in a comment nor in a CDATA section or an instruction.
std::optional<std::size_t> endOfRobot(std::string_view text) {
  std::optional<std::size_t> end;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kSkipped = {
      {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}};
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    const std::string_view rest = text.substr(at);
    const auto* const skipped =
        std::ranges::find_if(kSkipped, [&](const auto& s) { return rest.starts_with(s.first); });
    if (skipped != kSkipped.end()) {
      at = text.find(skipped->second, at);
      if (at == std::string_view::npos) break;
      continue;
    }
    if (rest.starts_with("</robot")) end = at;
    ++at;
  }
  return end;
}

/// A name of the skin that the robot has already: a second one would make the file useless.
[[noreturn]] void failTaken(const RobotUrdf& robot, const Message& what, const std::string& name) {
  throw FormatError(robot.model.file().string(),
                    message("already has a {} {}: if this is an earlier skin, give the robot's own file, else choose "
                            "another prefix of names",
                            what, name));
}

/// Names of the elements of a kind in the robot.
std::set<std::string> namesOf(pugi::xml_node robot, const char* kind) {
  std::set<std::string> names;
  for (const pugi::xml_node node : robot.children(kind)) names.insert(node.attribute("name").value());
  return names;
}

void requireFits(const RobotUrdf& robot, const std::set<std::string>& sensors, const UrdfContent& content) {
  for (const SkinTreePatch& patch : content.tree.patches) std::ignore = robot.model.linkNamed(patch.link);  // throws
  for (const SkinFrame& frame : skinFrames(content.tree, content.link_per_cell)) {
    const std::string joint = frame.name + "_joint";
    if (robot.model.findLink(frame.name)) failTaken(robot, message("link"), frame.name);
    if (robot.model.findJoint(joint)) failTaken(robot, message("joint"), joint);
  }
  if (content.link_per_cell) return;
  for (const SkinTreePatch& patch : content.tree.patches) {
    for (const SkinTreeCell& cell : patch.cells) {
      for (const SkinTreeSensor& sensor : cell.sensors) {
        if (sensors.contains(sensor.name)) failTaken(robot, message("sensor"), sensor.name);
      }
    }
  }
}

/// The elements of the skin, indented, each line ended.
std::string fragment(const UrdfContent& content, const std::set<std::string>& materials) {
  pugi::xml_document document;
  appendComment(document, commentOf(content));
  appendMaterials(document, materials);
  const CellBoxes boxes = cellBoxes(content.tree);
  for (const SkinTreePatch& patch : content.tree.patches) appendPatch(document, patch, boxes, content.link_per_cell);
  std::ostringstream out;
  for (const pugi::xml_node node : document.children())
    node.print(out, "  ", pugi::format_default, pugi::encoding_utf8, 1);
  return std::move(out).str();
}

}  // namespace

std::string urdfBytes(const UrdfContent& content) {
  pugi::xml_document document;
  declareXml(document);
  pugi::xml_node robot = appendElement(document, "robot", {{"name", content.tree.model}});
  if (content.form == UrdfForm::Macro) robot.append_attribute("xmlns:xacro") = kXacroNamespace;
  appendComment(robot, commentOf(content));
  appendMaterials(robot, {});
  if (content.form == UrdfForm::Alone) {
    for (const std::string& link : content.tree.links) appendLink(robot, link);
  }
  const CellBoxes boxes = cellBoxes(content.tree);
  for (const SkinTreePatch& patch : content.tree.patches) {
    if (content.form == UrdfForm::Macro) {
      appendMacro(robot, patch, boxes, content.link_per_cell);
    } else {
      appendPatch(robot, patch, boxes, content.link_per_cell);
    }
  }
  return xmlText(document, "  ");
}

RobotUrdf readRobotUrdf(const std::filesystem::path& path) {
  std::string text = readFile(path, kMaxRobotBytes);
  RobotModel model = RobotModel::parse(text, path);
  return {std::move(text), std::move(model)};
}

std::string robotUrdfBytes(const RobotUrdf& robot, const UrdfContent& content) {
  const std::optional<std::size_t> end = endOfRobot(robot.text);
  if (!end) throw FormatError(robot.model.file().string(), message("expected an end tag </robot>, but there is none"));
  pugi::xml_document document;
  document.load_buffer(robot.text.data(), robot.text.size());  // well-formed, for the model was made of it
  const pugi::xml_node root = document.document_element();
  requireFits(robot, namesOf(root, "sensor"), content);
  std::string added = fragment(content, namesOf(root, "material"));
  // On lines of its own, in the manner of the file.
  std::size_t at = *end;
  const std::size_t line = robot.text.find_last_of('\n', *end);
  const std::size_t line_begin = line == std::string::npos ? 0 : line + 1;
  const std::string_view before = std::string_view(robot.text).substr(line_begin, *end - line_begin);
  if (before.find_first_not_of(" \t") == std::string_view::npos) {
    at = line_begin;
  } else {
    added.insert(0, "\n");
  }
  if (robot.text.find("\r\n") != std::string::npos) boost::algorithm::replace_all(added, "\n", "\r\n");
  return robot.text.substr(0, at) + added + robot.text.substr(at);
}

}  // namespace hexoderm
