#include "hexoderm/io/export_urdf.h"

#include "hexoderm/io/export_support.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/text.h"

#include <algorithm>
#include <array>
#include <map>
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
constexpr std::uintmax_t kMostRobotBytes = 50'000'000;

void appendOrigin(pugi::xml_node parent, const SE3& T) {
  pugi::xml_node origin = parent.append_child("origin");
  origin.append_attribute("xyz") = vectorText(T.t).c_str();
  origin.append_attribute("rpy") = vectorText(rpyFromRotation(T.R)).c_str();
}

std::string boxName(const SkinTreeCell& cell, std::size_t box) { return cell.name + "_" + std::to_string(box + 1); }

/// The prism of a cell, in a link in whose frame the cell is at `T_link_u`.
void appendVisuals(pugi::xml_node link, const SkinTreeCell& cell, const SE3& T_link_u, const CellBoxes& boxes) {
  for (std::size_t k = 0; k < boxes.T_u_box.size(); ++k) {
    pugi::xml_node visual = link.append_child("visual");
    visual.append_attribute("name") = boxName(cell, k).c_str();
    appendOrigin(visual, T_link_u * boxes.T_u_box[k]);
    visual.append_child("geometry").append_child("box").append_attribute("size") = vectorText(boxes.size_m).c_str();
    visual.append_child("material").append_attribute("name") = cell.material.c_str();
  }
}

void appendMaterials(pugi::xml_node robot, const std::set<std::string>& there) {
  for (const SkinMaterial& material : skinMaterials()) {
    if (there.contains(material.name)) continue;
    pugi::xml_node node = robot.append_child("material");
    node.append_attribute("name") = material.name.c_str();
    node.append_child("color").append_attribute("rgba") = rgbaText(material.rgb).c_str();
  }
}

pugi::xml_node appendJoint(pugi::xml_node robot, const std::string& child, const std::string& parent) {
  pugi::xml_node joint = robot.append_child("joint");
  joint.append_attribute("name") = (child + "_joint").c_str();
  joint.append_attribute("type") = "fixed";
  joint.append_child("parent").append_attribute("link") = parent.c_str();
  joint.append_child("child").append_attribute("link") = child.c_str();
  return joint;
}

pugi::xml_node appendLink(pugi::xml_node robot, const std::string& name) {
  pugi::xml_node link = robot.append_child("link");
  link.append_attribute("name") = name.c_str();
  return link;
}

/// The links of a patch and the joints within it, without the one that fixes it to the robot.
void appendInside(pugi::xml_node robot, const SkinTreePatch& patch, const CellBoxes& boxes, bool link_per_cell) {
  pugi::xml_node patch_link = appendLink(robot, patch.name);
  if (!link_per_cell) {
    for (const SkinTreeCell& cell : patch.cells) appendVisuals(patch_link, cell, cell.T_o_u, boxes);
    for (const SkinTreeCell& cell : patch.cells) {
      for (const SkinTreeSensor& sensor : cell.sensors) {
        pugi::xml_node node = robot.append_child("sensor");
        node.append_attribute("name") = sensor.name.c_str();
        node.append_child("parent").append_attribute("link") = patch.name.c_str();
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

constexpr std::string_view kXacroNamespace = "http://www.ros.org/wiki/xacro";

void appendMacro(pugi::xml_node robot, const SkinTreePatch& patch, const CellBoxes& boxes, bool link_per_cell) {
  if (patch.name.find('/') != std::string::npos) {
    throw InvalidArgument(
        located("prefix", message("\"{}\" is no name for a xacro macro: leave out the /", patch.name)));
  }
  pugi::xml_node macro = robot.append_child("xacro:macro");
  macro.append_attribute("name") = patch.name.c_str();
  macro.append_attribute("params") = ("parent:=" + patch.link + " xyz:='" + vectorText(patch.T_l_o.t) + "' rpy:='" +
                                      vectorText(rpyFromRotation(patch.T_l_o.R)) + "'")
                                         .c_str();
  pugi::xml_node origin = appendJoint(macro, patch.name, "${parent}").append_child("origin");
  origin.append_attribute("xyz") = "${xyz}";
  origin.append_attribute("rpy") = "${rpy}";
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

std::string documentText(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, "  ");
  return std::move(out).str();
}

// Reading back.

std::string attributeOf(pugi::xml_node node, const char* name) { return node.attribute(name).value(); }

/// The values of a macro's parameters, empty outside a macro.
struct MacroDefaults {
  std::map<std::string, std::string> values;

  static MacroDefaults of(pugi::xml_node macro) {
    MacroDefaults defaults;
    const std::string text = attributeOf(macro, "params");
    for (const char* name : {"parent", "xyz", "rpy"}) {
      const std::string start = std::string(name) + ":=";
      const std::size_t at = text.find(start);
      if (at == std::string::npos) continue;
      std::size_t begin = at + start.size();
      const char end_mark = begin < text.size() && text[begin] == '\'' ? '\'' : ' ';
      if (end_mark == '\'') ++begin;
      defaults.values["${" + std::string(name) + "}"] = text.substr(begin, text.find(end_mark, begin) - begin);
    }
    return defaults;
  }
  [[nodiscard]] std::string resolved(const std::string& text) const {
    const auto found = values.find(text);
    return found == values.end() ? text : found->second;
  }
};

SE3 readOrigin(pugi::xml_node parent, const std::string& file, const MacroDefaults& defaults = {}) {
  const pugi::xml_node origin = parent.child("origin");
  return transformOf(vectorFromText(defaults.resolved(attributeOf(origin, "xyz")), file),
                     vectorFromText(defaults.resolved(attributeOf(origin, "rpy")), file));
}

struct ReadJoint {
  std::string parent;
  bool fixed = false;
  pugi::xml_node node;
  const MacroDefaults* defaults = nullptr;
};

/// Links, joints and sensors of a document, those in macros too.
struct ReadUrdf {
  pugi::xml_document document;
  std::vector<MacroDefaults> defaults;
  std::map<std::string, pugi::xml_node> links;
  std::map<std::string, ReadJoint> joint_of;  ///< by child link
  std::set<std::string> joints;
  std::map<std::string, pugi::xml_node> sensors;
  std::set<std::string> materials;

  ReadUrdf(std::string_view bytes, const std::string& file) {
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed) throw FormatError(file + ": cannot be read back as XML: " + parsed.description());
    const pugi::xml_node robot = document.child("robot");
    requireMeant(!robot.empty(), file, "expected the root element robot");
    std::vector<pugi::xml_node> macros;
    for (const pugi::xml_node macro : robot.children("xacro:macro")) macros.push_back(macro);
    defaults.reserve(macros.size() + 1);
    take(robot, defaults.emplace_back(), file);
    for (const pugi::xml_node macro : macros) take(macro, defaults.emplace_back(MacroDefaults::of(macro)), file);
  }

 private:
  void take(pugi::xml_node parent, const MacroDefaults& its_defaults, const std::string& file) {
    for (const pugi::xml_node node : parent.children()) {
      const std::string kind = node.name();
      const std::string name = attributeOf(node, "name");
      const auto once = [&](bool added) {
        if (!added) throw FormatError(located(file, message("expected each {} once, found {} again", kind, name)));
      };
      if (kind == "link") once(links.emplace(name, node).second);
      if (kind == "sensor") once(sensors.emplace(name, node).second);
      if (kind == "material") materials.insert(name);
      if (kind != "joint") continue;
      once(joints.insert(name).second);
      const std::string child = attributeOf(node.child("child"), "link");
      const std::string on = its_defaults.resolved(attributeOf(node.child("parent"), "link"));
      const bool added =
          joint_of.emplace(child, ReadJoint{on, attributeOf(node, "type") == "fixed", node, &its_defaults}).second;
      if (!added) throw FormatError(located(file, message("the link {} hangs on two joints", child)));
    }
  }
};

/// Where a link of the skin is in the link of the robot that its patch is fixed to.
void requireAt(const ReadUrdf& found, const std::string& name, const std::string& root, const SE3& T_root_meant,
               const std::string& file) {
  requireMeant(found.links.contains(name), file, "link " + name + " is missing");
  SE3 T_root_link;
  std::string at = name;
  // A chain longer than there are links would be a circle.
  for (std::size_t steps = 0; at != root && steps <= found.links.size(); ++steps) {
    const auto joint = found.joint_of.find(at);
    requireMeant(joint != found.joint_of.end(), file, "link " + at + " hangs on no joint");
    requireMeant(joint->second.fixed, file, "the joint of " + at + " is not fixed");
    T_root_link = readOrigin(joint->second.node, file, *joint->second.defaults) * T_root_link;
    at = joint->second.parent;
  }
  requireMeant(at == root && near(T_root_link, T_root_meant), file, "link " + name + " is elsewhere");
}

void requireParent(const ReadUrdf& found, const std::string& name, const std::string& parent, const std::string& file) {
  const auto joint = found.joint_of.find(name);
  requireMeant(joint != found.joint_of.end() && joint->second.parent == parent, file,
               "link " + name + " hangs on another link");
}

/// Takes the visuals of a cell off the front of those that are left.
void requireVisuals(pugi::xml_node& visual, const SkinTreeCell& cell, const SE3& T_link_u, const CellBoxes& boxes,
                    const std::string& file) {
  for (std::size_t k = 0; k < boxes.T_u_box.size(); ++k) {
    const std::string what = "visual " + boxName(cell, k);
    requireMeant(attributeOf(visual, "name") == boxName(cell, k), file, what + " is missing");
    requireMeant(near(readOrigin(visual, file), T_link_u * boxes.T_u_box[k]), file, what + " is elsewhere");
    requireMeant(attributeOf(visual.child("geometry").child("box"), "size") == vectorText(boxes.size_m), file,
                 what + " has another size");
    requireMeant(attributeOf(visual.child("material"), "name") == cell.material, file, what + " has another colour");
    visual = visual.next_sibling("visual");
  }
}

struct AddedCounts {
  std::size_t links = 0;
  std::size_t sensors = 0;
};

/// Compares every patch and what is in it; returns how much of it there is.
AddedCounts requireSkin(const ReadUrdf& found, const UrdfContent& content, const std::string& file) {
  const CellBoxes boxes = cellBoxes(content.tree);
  AddedCounts added;
  const auto noFurther = [&](pugi::xml_node visual, const std::string& link) {
    requireMeant(!visual, file, "link " + link + " has further visuals");
  };
  const auto requireSensor = [&](const SkinTreeSensor& sensor, const SkinTreePatch& patch, const SkinTreeCell& cell) {
    if (content.link_per_cell) {
      requireParent(found, sensor.name, cell.name, file);
      requireAt(found, sensor.name, patch.link, patch.T_l_o * sensor.T_o_s, file);
      ++added.links;
      return;
    }
    const auto node = found.sensors.find(sensor.name);
    requireMeant(node != found.sensors.end() && attributeOf(node->second.child("parent"), "link") == patch.name &&
                     near(readOrigin(node->second, file), sensor.T_o_s),
                 file, "sensor " + sensor.name + " is missing or elsewhere");
    ++added.sensors;
  };
  for (const SkinTreePatch& patch : content.tree.patches) {
    requireAt(found, patch.name, patch.link, patch.T_l_o, file);
    requireParent(found, patch.name, patch.link, file);
    ++added.links;
    pugi::xml_node patch_visual = found.links.at(patch.name).child("visual");
    for (const SkinTreeCell& cell : patch.cells) {
      if (content.link_per_cell) {
        requireParent(found, cell.name, patch.name, file);
        requireAt(found, cell.name, patch.link, patch.T_l_o * cell.T_o_u, file);
        ++added.links;
        pugi::xml_node visual = found.links.at(cell.name).child("visual");
        requireVisuals(visual, cell, {}, boxes, file);
        noFurther(visual, cell.name);
      } else {
        requireVisuals(patch_visual, cell, cell.T_o_u, boxes, file);
      }
      for (const SkinTreeSensor& sensor : cell.sensors) requireSensor(sensor, patch, cell);
    }
    noFurther(patch_visual, patch.name);
  }
  return added;
}

// The robot's own description.

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
  throw FormatError(
      located(robot.model.file().string(),
              message("already has a {} {}: if this is an earlier skin, give the robot's own file, else choose "
                      "another prefix of names",
                      what, name)));
}

void requireFits(const RobotUrdf& robot, const ReadUrdf& found, const UrdfContent& content) {
  for (const SkinTreePatch& patch : content.tree.patches) std::ignore = robot.model.linkNamed(patch.link);  // throws
  const auto requireFree = [&](const SkinFrame& frame, bool is_link) {
    if (is_link && robot.model.findLink(frame.name)) failTaken(robot, message("link"), frame.name);
    if (is_link && robot.model.findJoint(frame.name + "_joint")) {
      failTaken(robot, message("joint"), frame.name + "_joint");
    }
    if (!is_link && found.sensors.contains(frame.name)) failTaken(robot, message("sensor"), frame.name);
  };
  for (const SkinFrame& frame : skinFrames(content.tree, content.link_per_cell)) requireFree(frame, true);
  if (content.link_per_cell) return;
  for (const SkinTreePatch& patch : content.tree.patches) {
    for (const SkinTreeCell& cell : patch.cells) {
      for (const SkinTreeSensor& sensor : cell.sensors) requireFree({sensor.name, "", {}}, false);
    }
  }
}

/// The elements of the skin, indented, each line ended.
std::string fragment(const UrdfContent& content, const std::set<std::string>& materials) {
  pugi::xml_document document;
  document.append_child(pugi::node_comment).set_value(commentOf(content).c_str());
  appendMaterials(document, materials);
  const CellBoxes boxes = cellBoxes(content.tree);
  for (const SkinTreePatch& patch : content.tree.patches) appendPatch(document, patch, boxes, content.link_per_cell);
  std::ostringstream out;
  for (const pugi::xml_node node : document.children())
    node.print(out, "  ", pugi::format_default, pugi::encoding_utf8, 1);
  return std::move(out).str();
}

/// What is inserted into the robot's text, and where.
struct Insertion {
  std::size_t at = 0;
  std::string text;
};

Insertion insertionInto(const RobotUrdf& robot, const UrdfContent& content) {
  const std::optional<std::size_t> end = endOfRobot(robot.text);
  if (!end)
    throw FormatError(located(robot.model.file().string(), message("expected an end tag </robot>, but there is none")));
  const ReadUrdf found(robot.text, robot.model.file().string());
  requireFits(robot, found, content);
  Insertion insertion{*end, fragment(content, found.materials)};
  // On lines of its own, in the manner of the file.
  const std::size_t line = robot.text.find_last_of('\n', *end);
  const std::size_t line_begin = line == std::string::npos ? 0 : line + 1;
  const std::string_view before = std::string_view(robot.text).substr(line_begin, *end - line_begin);
  if (before.find_first_not_of(" \t") == std::string_view::npos) {
    insertion.at = line_begin;
  } else {
    insertion.text.insert(0, "\n");
  }
  if (robot.text.find("\r\n") != std::string::npos) {
    std::string with_returns;
    for (const char c : insertion.text) with_returns += c == '\n' ? "\r\n" : std::string(1, c);
    insertion.text = std::move(with_returns);
  }
  return insertion;
}

}  // namespace

std::string urdfBytes(const UrdfContent& content) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node robot = document.append_child("robot");
  robot.append_attribute("name") = content.tree.model.c_str();
  if (content.form == UrdfForm::Macro) robot.append_attribute("xmlns:xacro") = std::string(kXacroNamespace).c_str();
  robot.append_child(pugi::node_comment).set_value(commentOf(content).c_str());
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
  return documentText(document);
}

void verifyUrdf(std::string_view bytes, const UrdfContent& content, const std::string& file) {
  const ReadUrdf found(bytes, file);
  requireMeant(attributeOf(found.document.child("robot"), "name") == content.tree.model, file,
               "expected robot " + content.tree.model);
  const AddedCounts added = requireSkin(found, content, file);
  const std::size_t roots = content.form == UrdfForm::Alone ? content.tree.links.size() : 0;
  for (std::size_t k = 0; k < roots; ++k) {
    requireMeant(found.links.contains(content.tree.links[k]), file, "link " + content.tree.links[k] + " is missing");
  }
  requireMeant(found.links.size() == added.links + roots && found.joint_of.size() == added.links, file,
               "expected " + std::to_string(added.links + roots) + " links in one tree");
  requireMeant(found.sensors.size() == added.sensors, file, "expected no further sensor");
}

RobotUrdf readRobotUrdf(const std::filesystem::path& path) {
  std::string text = readFile(path, kMostRobotBytes);
  RobotModel model = RobotModel::parse(text, path);
  return {std::move(text), std::move(model)};
}

std::string robotUrdfBytes(const RobotUrdf& robot, const UrdfContent& content) {
  const Insertion insertion = insertionInto(robot, content);
  return robot.text.substr(0, insertion.at) + insertion.text + robot.text.substr(insertion.at);
}

void verifyRobotUrdf(std::string_view bytes, const RobotUrdf& robot, const UrdfContent& content,
                     const std::string& file) {
  const std::size_t at = insertionInto(robot, content).at;
  const std::size_t rest = robot.text.size() - at;
  requireMeant(bytes.size() >= robot.text.size() && bytes.substr(0, at) == std::string_view(robot.text).substr(0, at) &&
                   bytes.substr(bytes.size() - rest) == std::string_view(robot.text).substr(at),
               file, "the robot's own text differs");
  const ReadUrdf before(robot.text, robot.model.file().string());
  const ReadUrdf found(bytes, file);
  const AddedCounts added = requireSkin(found, content, file);
  requireMeant(found.links.size() == before.links.size() + added.links &&
                   found.joints.size() == before.joints.size() + added.links &&
                   found.sensors.size() == before.sensors.size() + added.sensors,
               file, "expected " + std::to_string(added.links) + " further links");

  const RobotModel model = RobotModel::parse(bytes, file);
  const std::vector<SE3> T_w_l = model.forward({});
  for (const SkinFrame& frame : skinFrames(content.tree, content.link_per_cell)) {
    const SE3 T_parent_w = T_w_l[model.linkNamed(frame.parent)].inverse();
    requireMeant(near(T_parent_w * T_w_l[model.linkNamed(frame.name)], frame.T_parent_frame), file,
                 "by its kinematics link " + frame.name + " is elsewhere");
  }
}

}  // namespace hexoderm
