#include "hexoderm/session/session_parts_json.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/limits.h"
#include "hexoderm/util/message_json.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

/// What a cell has, as a rule.
constexpr std::size_t kUsualPorts = 6;

template <class In>
NeighborList neighborsFrom(In& json) {
  NeighborList neighbors;
  json.eachItem([&](auto& cell) {
    CellReport& report = neighbors.emplace_back();
    const auto ports = [&](auto& items) {
      report.neighbors.reserve(kUsualPorts);
      items.eachItem([&](auto& port) {
        NeighborReport& neighbor = report.neighbors.emplace_back();
        port.object(member("port", into(neighbor.port)), member("cell", into(neighbor.cell)),
                    optionalMember("cell_port", into(neighbor.cell_port)));
      });
    };
    cell.object(member("id", into(report.id)), optionalMember("body_part", into(report.body_part)),
                member("ports", ports));
  });
  neighbors.shrink_to_fit();
  return neighbors;
}

template <class In>
GroundTruth truthFrom(In& json) {
  GroundTruth truth;
  const auto cells = [&](auto& items) {
    items.eachItem([&](auto& item) {
      TrueCellPlacement& cell = truth.cells.emplace_back();
      item.object(member("id", into(cell.id)), member("R", [&](auto& in) { cell.T_b_u.R = in.rotation(); }),
                  member("t_m", [&](auto& in) { cell.T_b_u.t = in.vector3(kMostLength_m); }));
    });
  };
  json.object(optionalMember("frame", into(truth.frame)), member("cells", cells));
  truth.cells.shrink_to_fit();
  return truth;
}

}  // namespace

NeighborList readNeighbors(const JsonReader& json) { return neighborsFrom(json); }
NeighborList scanNeighbors(JsonScanner& json) { return neighborsFrom(json); }

void writeNeighbors(const NeighborList& neighbors, JsonWriter& json) {
  json.array(neighbors, [&](const CellReport& report) {
    json.beginObject();
    json.member("id", report.id.value());
    if (!report.body_part.empty()) json.member("body_part", report.body_part);
    json.arrayMember("ports", report.neighbors, [&](const NeighborReport& neighbor) {
      json.beginObject();
      json.member("port", neighbor.port.value());
      json.member("cell", neighbor.cell.value());
      if (neighbor.cell_port) json.member("cell_port", neighbor.cell_port->value());
      json.endObject();
    });
    json.endObject();
  });
}

MutedLink readMutedLink(const JsonReader& json) {
  const auto end = [&](const char* cell, const char* port) {
    return LinkEnd{CellId(json.at(cell).unsignedInteger()), PortNumber(json.at(port).unsignedInteger())};
  };
  const LinkEnd a = end("source", "source_port");
  const LinkEnd b = end("target", "target_port");
  if (a == b) json.at("target_port").fail(message("another port than the source's: a link has two ends"));
  const auto why = json.find("why");
  return {std::min(a, b), std::max(a, b), why ? why->string() : std::string()};
}

Json mutedLinkJson(const MutedLink& link) {
  Json json;
  json["source"] = link.source.cell.value();
  json["source_port"] = link.source.port.value();
  json["target"] = link.target.cell.value();
  json["target_port"] = link.target.port.value();
  if (!link.why.empty()) json["why"] = link.why;
  return json;
}

JointAngles readJointAngles(const JsonReader& json) {
  JointAngles angles;
  for (const JsonReader& item : json.items()) {
    const std::string joint = item.at("joint").string();
    if (joint.empty()) item.at("joint").fail(message("the name of a joint"));
    const double position = item.at("position").number();
    if (std::abs(position) > kMostJointPosition) {
      item.at("position").fail(message("a position of at most {}", Number{kMostJointPosition, 0}));
    }
    if (!angles.positions.emplace(joint, position).second) item.at("joint").fail(message("each joint once"));
  }
  return angles;
}

Json jointAnglesJson(const JointAngles& angles) {
  Json json = Json::array();
  for (const auto& [joint, position] : angles.positions) json.push_back({{"joint", joint}, {"position", position}});
  return json;
}

std::optional<RobotDescription> readRobot(const JsonReader& json) {
  const auto urdf = json.find("urdf");
  if (!urdf) return std::nullopt;
  RobotDescription robot{urdf->string(), json.at("sha256").string(), {}};
  if (robot.urdf.empty()) urdf->fail(message("the name of a file"));
  if (const auto packages = json.find("packages")) {
    for (const JsonReader& item : packages->items()) {
      const std::string name = item.at("name").string();
      const std::string folder = item.at("folder").string();
      if (name.empty() || folder.empty()) item.fail(message("a name and a folder"));
      if (!robot.packages.emplace(name, folder).second) item.at("name").fail(message("each package once"));
    }
  }
  return robot;
}

Json robotJson(const std::optional<RobotDescription>& robot) {
  Json json = Json::object();
  if (!robot) return json;
  json["urdf"] = robot->urdf;
  json["sha256"] = robot->sha256;
  for (const auto& [name, folder] : robot->packages) json["packages"].push_back({{"name", name}, {"folder", folder}});
  return json;
}

void readPlace(const JsonReader& json, PatchOnLink& place) {
  place.T_l_o = {json.at("R").rotation(), json.at("t_m").vector3(kMostLength_m)};
  const auto cov = json.find("cov_t_r");
  if (!cov) return;
  const Matrix6d cov_t_r = fromUpperTriangle<6>(cov->numbers<21>());
  if (!isCovariance(cov_t_r)) cov->fail(message("a covariance (positive semidefinite)"));
  place.cov_t_r = cov_t_r;
}

void writePlace(const PatchOnLink& place, Json& json) {
  json["R"] = toJson(place.T_l_o.R);
  json["t_m"] = toJson(place.T_l_o.t);
  if (place.cov_t_r) json["cov_t_r"] = upperTriangle(*place.cov_t_r);
}

PatchPlacement readPlacement(const JsonReader& json) {
  PatchPlacement placement;
  placement.origin = CellId(json.at("origin_cell").unsignedInteger(1));
  if (const auto link = json.find("link")) placement.link = link->string();
  if (const auto chosen = json.find("link_chosen")) placement.link_chosen = chosen->boolean();
  placement.by_surface = json.at("by_surface").boolean();
  if (const auto points = json.find("points")) {
    for (const JsonReader& item : points->items()) {
      placement.points.push_back({CellId(item.at("cell").unsignedInteger(1)), item.at("x_l_m").vector3(kMostLength_m),
                                  item.at("sigma_m").positiveNumber()});
    }
  }
  if (const auto distances = json.find("distances")) {
    for (const JsonReader& item : distances->items()) {
      placement.distances.push_back({CellId(item.at("from_cell").unsignedInteger(1)),
                                     CellId(item.at("to_cell").unsignedInteger(1)),
                                     item.at("distance_m").positiveNumber(), item.at("sigma_m").positiveNumber()});
    }
  }
  if (const auto place = json.find("place")) {
    placement.place = PatchOnLink{placement.origin, placement.link, {}, {}};
    readPlace(*place, *placement.place);
  }
  try {
    placement.validate();
  } catch (const InvalidArgument& error) {
    json.fail(message("a placement that makes sense ({})", error.message()));
  }
  return placement;
}

Json placementJson(const PatchPlacement& placement) {
  Json json = {{"origin_cell", placement.origin.value()}};
  if (!placement.link.empty()) json["link"] = placement.link;
  if (placement.link_chosen) json["link_chosen"] = true;
  json["by_surface"] = placement.by_surface;
  for (const KnownPoint& point : placement.points) {
    json["points"].push_back({{"cell", point.cell.value()}, {"x_l_m", toJson(point.x_l)}, {"sigma_m", point.sigma_m}});
  }
  for (const KnownDistance& distance : placement.distances) {
    json["distances"].push_back({{"from_cell", distance.a.value()},
                                 {"to_cell", distance.b.value()},
                                 {"distance_m", distance.distance_m},
                                 {"sigma_m", distance.sigma_m}});
  }
  if (placement.place) writePlace(*placement.place, json["place"]);
  return json;
}

std::vector<PatchPlacement> readPlacements(const JsonReader& json) {
  std::vector<PatchPlacement> placements;
  std::set<CellId> origins;
  for (const JsonReader& item : json.items()) {
    placements.push_back(readPlacement(item));
    if (!origins.insert(placements.back().origin).second) {
      item.at("origin_cell").fail(message("each patch once; that of cell {} is there twice", placements.back().origin));
    }
  }
  return placements;
}

Json placementsJson(const std::vector<PatchPlacement>& placements) {
  Json json = Json::array();
  for (const PatchPlacement& placement : placements) json.push_back(placementJson(placement));
  return json;
}

SessionPose readPose(const JsonReader& json, const std::string& id_key,
                     const std::function<std::vector<GravitySample>()>& take_samples) {
  PoseCapture capture;
  // One below the largest number, so that there is always an ID for the next pose.
  capture.id = PoseId(json.at(id_key).unsignedInteger(0, UINT32_MAX - 1));
  if (json.find("label")) capture.label = readMessage(json, "label");
  if (const auto taken = json.find("taken_at_ms")) capture.taken_at_ms = taken->integer();
  capture.samples = take_samples();
  SessionPose pose{std::make_shared<const PoseCapture>(std::move(capture))};
  if (const auto disabled = json.find("disabled")) pose.disabled = disabled->boolean();
  if (const auto why = json.find("why_disabled")) pose.why_disabled = why->string();
  if (const auto joints = json.find("joint_angles")) pose.joint_angles = readJointAngles(*joints);
  return pose;
}

GroundTruth readTruth(const JsonReader& json) {
  GroundTruth truth = truthFrom(json);
  std::set<CellId> known;
  for (std::size_t k = 0; k < truth.cells.size(); ++k) {
    if (!known.insert(truth.cells[k].id).second) json.at("cells").items()[k].failAt("id", message("each cell once"));
  }
  return truth;
}

GroundTruth scanTruth(JsonScanner& json) {
  GroundTruth truth = truthFrom(json);
  std::vector<CellId> ids;
  ids.reserve(truth.cells.size());
  for (const TrueCellPlacement& cell : truth.cells) ids.push_back(cell.id);
  std::ranges::sort(ids);
  if (std::ranges::adjacent_find(ids) != ids.end()) throw JsonScanner::Unusual();
  return truth;
}

void writeTruth(const GroundTruth& truth, JsonWriter& json) {
  json.beginObject();
  json.member("frame", truth.frame);
  json.arrayMember("cells", truth.cells, [&](const TrueCellPlacement& cell) {
    json.beginObject();
    json.member("id", cell.id.value());
    json.member("R", cell.T_b_u.R);
    json.member("t_m", cell.T_b_u.t);
    json.endObject();
  });
  json.endObject();
}

}  // namespace hexoderm
