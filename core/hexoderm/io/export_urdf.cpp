#include "hexoderm/io/export_urdf.h"

#include "hexoderm/io/export_support.h"
#include "hexoderm/reconstruction/result/quality_colors.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"

#include <algorithm>
#include <array>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kTolerance = 1e-9;
constexpr const char* kMaterialPrefix = "hexoderm_";

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// A user's text as part of a name: what URDF does not take becomes one underscore.
std::string sanitised(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (isNameCharacter(c)) {
      name += c;
    } else if (!name.ends_with('_')) {
      name += '_';
    }
  }
  return name.empty() ? "sensor" : name;
}

/// Gives each name once; a second one of the same spelling gets a number.
class Names {
 public:
  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int k = 2; !taken_.insert(name).second; ++k) name = wanted + "_" + std::to_string(k);
    return name;
  }

 private:
  std::set<std::string> taken_;
};

struct Material {
  std::string name;
  std::uint32_t rgb = 0;
};

std::vector<Material> materials() {
  std::vector<Material> list;
  for (const EdgeQuality quality :
       {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully, EdgeQuality::Over}) {
    list.push_back({kMaterialPrefix + std::string(qualityName(quality)), qualityColor(quality, Background::Light)});
  }
  list.push_back({kMaterialPrefix + std::string("no_link"), unusedColor(Background::Light)});
  return list;
}

std::string numbers(const Eigen::Vector3d& v) {
  const Eigen::Vector3d w = v.array() + 0.0;  // no "-0"
  return formatExact(w.x()) + " " + formatExact(w.y()) + " " + formatExact(w.z());
}

void appendOrigin(pugi::xml_node parent, const SE3& T) {
  pugi::xml_node origin = parent.append_child("origin");
  origin.append_attribute("xyz") = numbers(T.t).c_str();
  origin.append_attribute("rpy") = numbers(rpyFromRotation(T.R)).c_str();
}

void appendVisual(pugi::xml_node link, const UrdfVisual& visual, const UrdfModel& model) {
  pugi::xml_node node = link.append_child("visual");
  node.append_attribute("name") = visual.name.c_str();
  appendOrigin(node, visual.T_link_center);
  pugi::xml_node cylinder = node.append_child("geometry").append_child("cylinder");
  cylinder.append_attribute("radius") = formatExact(model.radius_m).c_str();
  cylinder.append_attribute("length") = formatExact(model.length_m).c_str();
  node.append_child("material").append_attribute("name") = visual.material.c_str();
}

Eigen::Vector3d parseVector(const char* text, const std::string& file) {
  const std::vector<std::string> parts = split(text, ' ');
  requireMeant(parts.size() == 3, file, "expected three numbers, found \"" + std::string(text) + "\"");
  Eigen::Vector3d v;
  for (std::size_t k = 0; k < 3; ++k) {
    try {
      v[static_cast<Eigen::Index>(k)] = parseNumber(parts[k], "origin");
    } catch (const InvalidArgument& error) {
      throw FormatError(file + ": " + error.what());
    }
  }
  return v;
}

/// By the definition R = Rz(yaw) Ry(pitch) Rx(roll) written out, independent of the code that made the angles.
SE3 readOrigin(pugi::xml_node parent, const std::string& file) {
  const pugi::xml_node origin = parent.child("origin");
  const Eigen::Vector3d rpy = parseVector(origin.attribute("rpy").value(), file);
  const auto about = [](const Eigen::Vector3d& axis, double angle_rad) { return expSO3(angle_rad * axis); };
  return {about(Eigen::Vector3d::UnitZ(), rpy.z()) * about(Eigen::Vector3d::UnitY(), rpy.y()) *
              about(Eigen::Vector3d::UnitX(), rpy.x()),
          parseVector(origin.attribute("xyz").value(), file)};
}

bool near(const SE3& a, const SE3& b) {
  return (a.R - b.R).cwiseAbs().maxCoeff() <= kTolerance && (a.t - b.t).cwiseAbs().maxCoeff() <= kTolerance;
}

struct ReadJoint {
  std::string parent;
  SE3 T_parent_child;
};

std::map<std::string, ReadJoint> readJoints(pugi::xml_node robot, const std::string& file) {
  std::map<std::string, ReadJoint> joint_of;  // by child link
  std::set<std::string> names;
  for (const pugi::xml_node joint : robot.children("joint")) {
    const std::string name = joint.attribute("name").value();
    requireMeant(std::string_view(joint.attribute("type").value()) == "fixed", file, "joint " + name + " is not fixed");
    requireMeant(names.insert(name).second, file, "joint " + name + " is there twice");
    const std::string child = joint.child("child").attribute("link").value();
    const bool added =
        joint_of.try_emplace(child, ReadJoint{joint.child("parent").attribute("link").value(), readOrigin(joint, file)})
            .second;
    requireMeant(added, file, "link " + child + " hangs on two joints");
  }
  return joint_of;
}

void verifyVisuals(pugi::xml_node link, const UrdfLink& meant, const UrdfModel& model, const std::string& file) {
  pugi::xml_node visual = link.child("visual");
  for (const UrdfVisual& expected : meant.visuals) {
    const std::string what = "visual " + expected.name;
    requireMeant(std::string_view(visual.attribute("name").value()) == expected.name, file, what + " is missing");
    requireMeant(near(readOrigin(visual, file), expected.T_link_center), file, what + " is elsewhere");
    const pugi::xml_node cylinder = visual.child("geometry").child("cylinder");
    requireMeant(cylinder.attribute("radius").value() == formatExact(model.radius_m) &&
                     cylinder.attribute("length").value() == formatExact(model.length_m),
                 file, what + " has another size");
    requireMeant(visual.child("material").attribute("name").value() == expected.material, file,
                 what + " has another colour");
    visual = visual.next_sibling("visual");
  }
  requireMeant(!visual, file, "link " + meant.name + " has further visuals");
}

}  // namespace

bool isUrdfName(std::string_view name) {
  return !name.empty() && name.front() != '/' &&
         std::ranges::all_of(name, [](char c) { return isNameCharacter(c) || c == '-' || c == '.' || c == '/'; });
}

UrdfModel urdfModel(const Reconstruction& reconstruction, const ExportOptions& options) {
  const CellModel& cell_model = *reconstruction.model;
  const auto quality = worstUsedQuality(reconstruction);
  const SE3 T_u_center{Eigen::Matrix3d::Identity(), {0, 0, -cell_model.thickness_m / 2}};
  Names names;
  UrdfModel model;
  model.robot = options.urdf_robot;
  model.radius_m = cell_model.side_m;
  model.length_m = cell_model.thickness_m;
  model.links.push_back({names.unique(options.urdf_parent_link), "", {}, {}, {}});

  const auto nameOf = [&](const std::string& rest) {
    std::string name = options.urdf_prefix + rest;
    if (name == options.urdf_parent_link) {
      throw InvalidArgument("urdf_parent_link: \"" + name + "\" is also the name of a link of the skin");
    }
    return names.unique(name);
  };
  for (const PatchReconstruction& patch : reconstruction.patches) {
    // The patch's place on the robot is not known here: its frame is the parent link's until the user moves it.
    const std::size_t patch_link = model.links.size();
    const std::string patch_name = nameOf("patch" + toString(patch.id));
    model.links.push_back({patch_name, options.urdf_parent_link, {}, {}, {}});
    for (const CellPlacement& cell : patch.cells) {
      const SE3 T_o_u = rigid(cell.T_o_u);
      const std::string cell_name = nameOf("cell" + toString(cell.cell));
      const auto cell_quality = quality.find(cell.cell);
      const std::string material =
          kMaterialPrefix + std::string(cell_quality == quality.end() ? "no_link" : qualityName(cell_quality->second));
      if (options.urdf_link_per_cell) {
        model.links.push_back({cell_name, patch_name, T_o_u, T_o_u, {{cell_name, T_u_center, material}}});
      } else {
        model.links[patch_link].visuals.push_back({cell_name, T_o_u * T_u_center, material});
      }
      for (const SensorPlacement& sensor : cell.sensors) {
        const SE3 T_o_s = rigid(sensor.T_o_s);
        const std::string name = names.unique(cell_name + "_" + sanitised(sensor.name));
        if (options.urdf_link_per_cell) {
          model.links.push_back({name, cell_name, T_o_u.inverse() * T_o_s, T_o_s, {}});
        } else {
          model.sensors.push_back({name, patch_name, T_o_s});
        }
      }
    }
  }
  return model;
}

std::string urdfBytes(const UrdfModel& model) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node robot = document.append_child("robot");
  robot.append_attribute("name") = model.robot.c_str();
  robot.append_child(pugi::node_comment)
      .set_value(
          " Metres and radians. The patch has a link of its own, in the frame of its origin cell, joined to the parent "
          "link without any offset: placing it on the robot is up to you. ");
  for (const Material& material : materials()) {
    pugi::xml_node node = robot.append_child("material");
    node.append_attribute("name") = material.name.c_str();
    std::string rgba;
    for (const unsigned shift : {16U, 8U, 0U}) {
      rgba += formatFixed(static_cast<double>((material.rgb >> shift) & 0xFFU) / 255, 4) + " ";
    }
    node.append_child("color").append_attribute("rgba") = (rgba + "1").c_str();
  }
  for (const UrdfLink& link : model.links) {
    if (!link.parent.empty()) {
      pugi::xml_node joint = robot.append_child("joint");
      joint.append_attribute("name") = (link.name + "_joint").c_str();
      joint.append_attribute("type") = "fixed";
      joint.append_child("parent").append_attribute("link") = link.parent.c_str();
      joint.append_child("child").append_attribute("link") = link.name.c_str();
      appendOrigin(joint, link.T_parent_link);
    }
    pugi::xml_node node = robot.append_child("link");
    node.append_attribute("name") = link.name.c_str();
    for (const UrdfVisual& visual : link.visuals) appendVisual(node, visual, model);
  }
  for (const UrdfSensor& sensor : model.sensors) {
    pugi::xml_node node = robot.append_child("sensor");
    node.append_attribute("name") = sensor.name.c_str();
    node.append_child("parent").append_attribute("link") = sensor.link.c_str();
    appendOrigin(node, sensor.T_link_sensor);
  }
  std::ostringstream out;
  document.save(out, "  ");
  return std::move(out).str();
}

void verifyUrdf(std::string_view bytes, const UrdfModel& model, const std::string& file) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
  if (!parsed) throw FormatError(file + ": cannot be read back as XML: " + parsed.description());
  const pugi::xml_node robot = document.child("robot");
  requireMeant(robot.attribute("name").value() == model.robot, file, "expected robot " + model.robot);

  std::map<std::string, pugi::xml_node> links;
  for (const pugi::xml_node link : robot.children("link")) {
    const std::string name = link.attribute("name").value();
    requireMeant(links.emplace(name, link).second, file, "link " + name + " is there twice");
  }
  const auto joints = readJoints(robot, file);
  requireMeant(links.size() == model.links.size() && joints.size() + 1 == model.links.size(), file,
               "expected " + std::to_string(model.links.size()) + " links in one tree");

  for (const UrdfLink& meant : model.links) {
    const auto link = links.find(meant.name);
    requireMeant(link != links.end(), file, "link " + meant.name + " is missing");
    const auto own_joint = joints.find(meant.name);
    requireMeant((own_joint == joints.end() ? "" : own_joint->second.parent) == meant.parent, file,
                 "link " + meant.name + " hangs on another link");
    SE3 T_root_link;
    std::string at = meant.name;
    // A chain longer than there are links would be a circle.
    for (std::size_t steps = 0; at != model.links.front().name && steps <= model.links.size(); ++steps) {
      const auto joint = joints.find(at);
      requireMeant(joint != joints.end(), file, "link " + at + " hangs on no joint");
      T_root_link = joint->second.T_parent_child * T_root_link;
      at = joint->second.parent;
    }
    requireMeant(at == model.links.front().name && near(T_root_link, meant.T_root_link), file,
                 "link " + meant.name + " is elsewhere");
    verifyVisuals(link->second, meant, model, file);
  }

  pugi::xml_node sensor = robot.child("sensor");
  for (const UrdfSensor& meant : model.sensors) {
    requireMeant(sensor.attribute("name").value() == meant.name &&
                     sensor.child("parent").attribute("link").value() == meant.link &&
                     near(readOrigin(sensor, file), meant.T_link_sensor),
                 file, "sensor " + meant.name + " is missing or elsewhere");
    sensor = sensor.next_sibling("sensor");
  }
  requireMeant(!sensor, file, "expected no further sensor");
}

}  // namespace hexoderm
