#include "hexoderm/session/session_parts_json.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/limits.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

CellReport readCell(const JsonReader& json) {
  CellReport report;
  report.id = CellId(json.at("id").unsignedInteger());
  if (const auto part = json.find("body_part")) report.body_part = part->string();
  for (const JsonReader& port : json.at("ports").items()) {
    NeighborReport neighbor{PortNumber(port.at("port").unsignedInteger()), CellId(port.at("cell").unsignedInteger()),
                            std::nullopt};
    if (const auto cell_port = port.find("cell_port")) neighbor.cell_port = PortNumber(cell_port->unsignedInteger());
    report.neighbors.push_back(neighbor);
  }
  return report;
}

}  // namespace

NeighborList readNeighbors(const JsonReader& json) {
  NeighborList neighbors;
  for (const JsonReader& cell : json.items()) neighbors.push_back(readCell(cell));
  return neighbors;
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
  for (const auto& [name, folder] : robot->packages) {
    json["packages"].push_back({{"name", name}, {"folder", folder}});
  }
  return json;
}

void readPlace(const JsonReader& json, PatchOnLink& place) {
  place.T_l_o = {json.at("R").rotation(), json.at("t_m").vector3(kMostLength_m)};
  const auto cov = json.find("cov_t_r");
  if (!cov) return;
  const std::vector<double> values = cov->numbers(21);
  Matrix6d cov_t_r;
  std::size_t next = 0;
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = row; column < 6; ++column) {
      cov_t_r(row, column) = cov_t_r(column, row) = values[next++];
    }
  }
  if (!isCovariance(cov_t_r)) cov->fail(message("a covariance (positive semidefinite)"));
  place.cov_t_r = cov_t_r;
}

void writePlace(const PatchOnLink& place, Json& json) {
  json["R"] = toJson(place.T_l_o.R);
  json["t_m"] = toJson(place.T_l_o.t);
  if (!place.cov_t_r) return;
  json["cov_t_r"] = Json::array();
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = row; column < 6; ++column) json["cov_t_r"].push_back((*place.cov_t_r)(row, column));
  }
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

GroundTruth readTruth(const JsonReader& json) {
  GroundTruth truth;
  if (const auto frame = json.find("frame")) truth.frame = frame->string();
  std::set<CellId> known;
  for (const JsonReader& cell : json.at("cells").items()) {
    const CellId id(cell.at("id").unsignedInteger());
    if (!known.insert(id).second) cell.at("id").fail(message("each cell once"));
    truth.cells.push_back({id, {cell.at("R").rotation(), cell.at("t_m").vector3(kMostLength_m)}});
  }
  return truth;
}

}  // namespace hexoderm
