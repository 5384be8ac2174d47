#include "hexoderm/session/session_parts_json.h"

#include "hexoderm/base/error.h"

#include <algorithm>
#include <set>

namespace hexoderm {
namespace {

const Described kReportedPorts{[](auto& json, auto& neighbor) {
  json.object(requiredField("port", neighbor.port), requiredField("cell", neighbor.cell),
              optionalField("cell_port", neighbor.cell_port));
}};
const Described kReportedCells{[](auto& json, auto& report) {
  json.object(requiredField("id", report.id), optionalField("body_part", report.body_part),
              requiredField("ports", report.neighbors, kReportedPorts));
}};

template <class Json, class Truth>
void truthFields(Json& json, Truth& truth) {
  const auto cell = [](auto& item, auto& placement) {
    item.object(requiredField("id", placement.id), requiredField("R", placement.T_b_u.R, kRotation),
                requiredField("t_m", placement.T_b_u.t, vectorWithin(kMaxLength_m)));
  };
  json.object(defaultedField("frame", truth.frame), requiredField("cells", truth.cells, Described{cell}));
}

template <class Json, class Link>
void mutedLinkFields(Json& json, Link& link) {
  json.object(requiredField("source", link.source.cell), requiredField("source_port", link.source.port),
              requiredField("target", link.target.cell), requiredField("target_port", link.target.port),
              optionalField("why", link.why));
}

/// A package of the robot's description, or the position of a joint.
struct Package {
  std::string name;
  std::string folder;
};
struct JointPosition {
  std::string joint;
  double position = 0;
};

template <class Json, class Item>
void packageFields(Json& json, Item& package) {
  json.object(requiredField("name", package.name), requiredField("folder", package.folder));
}

template <class Json, class Item>
void jointFields(Json& json, Item& joint) {
  json.object(requiredField("joint", joint.joint), requiredField("position", joint.position));
}

template <class Json, class Placement>
void placementFields(Json& json, Placement& placement) {
  const auto point = [](auto& item, auto& known) {
    item.object(requiredField("cell", known.cell, wholeFrom(1)),
                requiredField("x_l_m", known.x_l, vectorWithin(kMaxLength_m)),
                requiredField("sigma_m", known.sigma_m, kPositive));
  };
  const auto distance = [](auto& item, auto& known) {
    item.object(requiredField("from_cell", known.a, wholeFrom(1)), requiredField("to_cell", known.b, wholeFrom(1)),
                requiredField("distance_m", known.distance_m, kPositive),
                requiredField("sigma_m", known.sigma_m, kPositive));
  };
  const auto place = [](auto& item, auto& at) { placeFields(item, at); };
  json.object(requiredField("origin_cell", placement.origin, wholeFrom(1)), optionalField("link", placement.link),
              optionalField("link_chosen", placement.link_chosen), requiredField("by_surface", placement.by_surface),
              optionalField("points", placement.points, Described{point}),
              optionalField("distances", placement.distances, Described{distance}),
              optionalField("place", placement.place, Described{place}));
}

}  // namespace

NeighborList readNeighbors(const JsonReader& json) {
  NeighborList neighbors;
  kReportedCells.take(json, neighbors);
  return neighbors;
}
void writeNeighbors(const NeighborList& neighbors, JsonWriter& json) { kReportedCells.put(json, neighbors); }

MutedLink readMutedLink(const JsonReader& json) {
  MutedLink link;
  mutedLinkFields(json, link);
  if (link.source == link.target) {
    json.failAt("target_port", message("another port than the source's: a link has two ends"));
  }
  if (link.target < link.source) std::swap(link.source, link.target);
  return link;
}
void writeMutedLink(const MutedLink& link, JsonWriter& json) { mutedLinkFields(json, link); }

void AsJointAngles::take(const JsonReader& in, Positions& positions) const {
  for (const JsonReader& item : in.items()) {
    JointPosition joint;
    jointFields(item, joint);
    if (joint.joint.empty()) item.failAt("joint", message("the name of a joint"));
    if (std::abs(joint.position) > kMaxJointPosition) {
      item.failAt("position", message("a position of at most {}", Number{kMaxJointPosition, 0}));
    }
    if (!positions.emplace(joint.joint, joint.position).second) item.failAt("joint", message("each joint once"));
  }
}
void AsJointAngles::put(JsonWriter& out, const Positions& positions) const {
  out.array(positions, [&](const auto& joint) {
    const JointPosition position{joint.first, joint.second};
    jointFields(out, position);
  });
}

std::string_view skinSideName(SkinSide side) {
  return side == SkinSide::Convex ? "convex" : side == SkinSide::Concave ? "concave" : "";
}
std::optional<SkinSide> skinSideFromName(std::string_view name) {
  for (const SkinSide side : {SkinSide::Convex, SkinSide::Concave}) {
    if (name == skinSideName(side)) return side;
  }
  return std::nullopt;
}

SkinSide readSkinSide(const JsonReader& json) {
  SkinSide side = SkinSide::Unknown;
  if (const auto surface = json.find("surface")) {
    Named{skinSideName, skinSideFromName, [] { return message("\"convex\" or \"concave\""); }}.take(*surface, side);
  }
  return side;
}

void writeSkinSide(SkinSide side, JsonWriter& json) {
  if (side != SkinSide::Unknown) json.member("surface", skinSideName(side));
}

std::optional<RobotDescription> readRobot(const JsonReader& json) {
  if (!json.find("urdf")) return std::nullopt;
  RobotDescription robot;
  json.object(requiredField("urdf", robot.urdf), requiredField("sha256", robot.sha256));
  if (robot.urdf.empty()) json.failAt("urdf", message("the name of a file"));
  if (const auto packages = json.find("packages")) {
    for (const JsonReader& item : packages->items()) {
      Package package;
      packageFields(item, package);
      if (package.name.empty() || package.folder.empty()) item.fail(message("a name and a folder"));
      if (!robot.packages.emplace(package.name, package.folder).second) {
        item.failAt("name", message("each package once"));
      }
    }
  }
  return robot;
}

void writeRobot(const std::optional<RobotDescription>& robot, JsonWriter& json) {
  json.beginObject();
  if (robot) {
    json.member("urdf", robot->urdf);
    json.member("sha256", robot->sha256);
    if (!robot->packages.empty()) {
      json.arrayMember("packages", robot->packages, [&](const auto& folder) {
        const Package package{folder.first, folder.second};
        packageFields(json, package);
      });
    }
  }
  json.endObject();
}

PatchPlacement readPlacement(const JsonReader& json) {
  PatchPlacement placement;
  placementFields(json, placement);
  if (placement.place) {
    placement.place->origin = placement.origin;
    placement.place->link = placement.link;
  }
  try {
    placement.validate();
  } catch (const InvalidArgument& error) {
    json.fail(message("a placement that makes sense ({})", error.message()));
  }
  return placement;
}
void writePlacement(const PatchPlacement& placement, JsonWriter& json) { placementFields(json, placement); }

std::vector<PatchPlacement> readPlacements(const JsonReader& json) {
  std::vector<PatchPlacement> placements;
  std::set<CellId> origins;
  for (const JsonReader& item : json.items()) {
    placements.push_back(readPlacement(item));
    requireOriginOnce(item, placements.back().origin, origins);
  }
  return placements;
}

void requireOriginOnce(const JsonReader& item, CellId origin, std::set<CellId>& origins) {
  if (origins.insert(origin).second) return;
  item.failAt("origin_cell", message("each patch once; that of cell {} is there twice", origin));
}

void writeRobotMembers(const std::optional<RobotDescription>& robot, const std::vector<PatchPlacement>& placements,
                       JsonWriter& json) {
  if (robot) {
    json.key("robot");
    writeRobot(robot, json);
  }
  if (placements.empty()) return;
  json.arrayMember("placements", placements,
                   [&](const PatchPlacement& placement) { placementFields(json, placement); });
}

SessionPose readPose(const JsonReader& json, const std::string& id_key,
                     const std::function<std::vector<GravitySample>()>& take_samples) {
  PoseCapture capture;
  SessionPose pose;
  poseFields(json, id_key, capture, pose);
  capture.samples = take_samples();
  pose.capture = std::make_shared<const PoseCapture>(std::move(capture));
  return pose;
}

GroundTruth readTruth(const JsonReader& json) {
  GroundTruth truth;
  truthFields(json, truth);
  std::set<CellId> known;
  for (std::size_t k = 0; k < truth.cells.size(); ++k) {
    if (!known.insert(truth.cells[k].id).second) json.at("cells").items()[k].failAt("id", message("each cell once"));
  }
  return truth;
}

void writeTruth(const GroundTruth& truth, JsonWriter& json) { truthFields(json, truth); }

}  // namespace hexoderm
