#include "hexoderm/session/session_parts_json.h"

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

Json cellJson(const CellReport& report) {
  Json json;
  json["id"] = report.id.value();
  if (!report.body_part.empty()) json["body_part"] = report.body_part;
  json["ports"] = Json::array();
  for (const NeighborReport& neighbor : report.neighbors) {
    Json port;
    port["port"] = neighbor.port.value();
    port["cell"] = neighbor.cell.value();
    if (neighbor.cell_port) port["cell_port"] = neighbor.cell_port->value();
    json["ports"].push_back(std::move(port));
  }
  return json;
}

}  // namespace

NeighborList readNeighbors(const JsonReader& json) {
  NeighborList neighbors;
  for (const JsonReader& cell : json.items()) neighbors.push_back(readCell(cell));
  return neighbors;
}

Json neighborsJson(const NeighborList& neighbors) {
  Json json = Json::array();
  for (const CellReport& report : neighbors) json.push_back(cellJson(report));
  return json;
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

Json truthJson(const GroundTruth& truth) {
  Json json;
  json["frame"] = truth.frame;
  json["cells"] = Json::array();
  for (const TrueCellPlacement& cell : truth.cells) {
    json["cells"].push_back({{"id", cell.id.value()}, {"R", toJson(cell.T_b_u.R)}, {"t_m", toJson(cell.T_b_u.t)}});
  }
  return json;
}

}  // namespace hexoderm
